//! A flexible body from its model, with invariants as tables.

use ffrf_codegen::DEFAULT_LAYOUT_TOLERANCE;
use ffrf_codegen::body::significant;
use ffrf_codegen::fidelity::{EnergyTerm, Fidelity};
use ffrf_codegen::invariants::{Invariant, Structure};
use ffrf_codegen::layout::found;
use ffrf_model::ReducedBody;
use ffrf_runtime::{
    FlexibleBody, GeneralisedForce, Marker, ModalMatrix, ModalVector, Observables, Prepared, SectionMarker,
    StressMarker,
};
use nalgebra::{DMatrix, DVector, Matrix3, RealField, Vector3, convert};

use super::HostModal;

/// Symmetric tensor: xx, yy, zz, xy, xz, yz.
type Symmetric<T = f64> = [T; 6];

/// A flexible body of run-time size; made in f64, and [`cast`](HostBody::cast) to number types that carry derivatives.
#[derive(Debug, Clone, PartialEq)]
pub struct HostBody<T: RealField + Copy = f64> {
    mass: T,
    /// m a, or zero.
    first_moment: Vector3<T>,
    /// Rows of m B. Shape: 3 x M.
    modal_first_moment: [HostModal<T>; 3],
    /// Θ.
    inertia: Symmetric<T>,
    /// Θ_μ + Θ_μᵀ. Shape: M.
    linear: Vec<Symmetric<T>>,
    /// Θ_νμ + Θ_μν, less twice the even part of the geometric stiffness of linear loads. Shape: M x M.
    quadratic: Vec<Vec<Symmetric<T>>>,
    /// ϑ_μ. Shape: M.
    rotation: Vec<Vector3<T>>,
    /// ϑ_νμ. Shape: M x M.
    whirl: Vec<Vec<Vector3<T>>>,
    /// -ϑ(Γ_μν) of linear loads. Shape: M x M, or none.
    second_order_rotation: Vec<Vec<Vector3<T>>>,
    /// -Γ_μν of uniform loads. Shape: M x M, or none.
    second_order_translation: Vec<Vec<Vector3<T>>>,
    /// Γ of unit forces and moments at each marker of the model that has them. Shape: 6 x M x M, or none.
    marker_loads: Vec<Option<Box<[DMatrix<T>; 6]>>>,
    modal_mass: ModalMatrix<HostModal<T>, T>,
    stiffness: ModalMatrix<HostModal<T>, T>,
    damping: ModalMatrix<HostModal<T>, T>,
    is_stiffened: bool,
    largest_stable_step: Option<T>,
}

impl HostBody {
    /// The body of a model, with the terms of the kinetic energy that `fidelity` keeps, and with what generated code takes for
    /// zero as zero.
    ///
    /// The model must have passed its checks.
    pub fn new(body: &ReducedBody, fidelity: &Fidelity) -> Self {
        Self::within(&significant(body, DEFAULT_LAYOUT_TOLERANCE, false), fidelity, DEFAULT_LAYOUT_TOLERANCE)
    }

    /// The same of a body whose entries are [`significant`], and whose modal mass has the structure that holds within `tolerance`.
    pub(crate) fn within(body: &ReducedBody, fidelity: &Fidelity, tolerance: f64) -> Self {
        let modal_mass_structure = found(body, tolerance)[Invariant::ModalMass];
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
        let geometric = body.geometric_stiffness.as_ref();
        let centrifugal = geometric.filter(|_| keeps(EnergyTerm::CentrifugalStiffening));
        let stiffened = |mu: usize, nu: usize| {
            let stiffness = centrifugal.map_or([0.0; 6], |it| twice_inertia(&it.linear_load[nu][mu]));
            let inertia = when(quadratic, twice_inertia(&pairs[nu][mu]));
            core::array::from_fn(|k| inertia[k] - stiffness[k])
        };
        let angular = geometric.filter(|_| keeps(EnergyTerm::AngularAccelerationStiffening));
        let linear_acceleration = geometric.filter(|_| keeps(EnergyTerm::LinearAccelerationStiffening));
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
            quadratic: (0..modes).map(|nu| (0..modes).map(|mu| stiffened(mu, nu)).collect()).collect(),
            rotation: inertia
                .position_mode_moment
                .iter()
                .map(|moment| vector_when(modal_rotation, axial(moment)))
                .collect(),
            whirl: pairs
                .iter()
                .map(|row| row.iter().map(|moment| vector_when(deformed_rotation, axial(moment))).collect())
                .collect(),
            second_order_rotation: angular.map_or(Vec::new(), |it| {
                it.linear_load.iter().map(|row| row.iter().map(|moment| -axial(moment)).collect()).collect()
            }),
            second_order_translation: linear_acceleration.map_or(Vec::new(), |it| {
                let negative = |load: &[f64; 3]| -Vector3::from(*load);
                it.uniform_load.iter().map(|row| row.iter().map(negative).collect()).collect()
            }),
            marker_loads: geometric
                .filter(|it| !it.marker_loads.is_empty() && fidelity.keeps_load_stiffness())
                .map_or(Vec::new(), |it| {
                    let of_marker = |name: &str| {
                        let load = it.marker_loads.iter().find(|load| load.marker == name)?;
                        let axis =
                            |k: usize| DMatrix::from_fn(modes, modes, |mu, nu| load.stiffness[mu][nu][k]);
                        Some(Box::new(core::array::from_fn(axis)))
                    };
                    body.markers.iter().map(|marker| of_marker(&marker.name)).collect()
                }),
            modal_mass: matrix(modes, |mu, nu| match (modal_mass_structure, mu == nu) {
                (Structure::Identity, true) => 1.0,
                (Structure::Identity | Structure::Diagonal, false) => 0.0,
                _ => 0.5 * (trace(mu, nu) + trace(nu, mu)),
            }),
            stiffness: matrix(modes, |mu, nu| body.stiffness[mu][nu]),
            damping: matrix(modes, |mu, nu| body.damping[mu][nu]),
            is_stiffened: centrifugal.is_some() || angular.is_some() || linear_acceleration.is_some(),
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
            second_order_rotation: Vec::new(),
            second_order_translation: Vec::new(),
            marker_loads: Vec::new(),
            modal_mass: nothing(),
            stiffness: nothing(),
            damping: nothing(),
            is_stiffened: false,
            largest_stable_step: None,
        }
    }

    /// S(ω): what centrifugal forces at spin ω take from the stiffness of the modes, less what the stress that they leave adds
    /// to it in a body with geometric stiffness. Shape: M x M. `omega`: body frame.
    ///
    /// Source: (209), derivative of the modal part to q.
    pub fn centrifugal_softening(&self, omega: &Vector3<f64>) -> DMatrix<f64> {
        let (spin, modes) = (spin_products(omega), self.mode_count());
        DMatrix::from_fn(modes, modes, |mu, nu| {
            0.5 * spin.iter().zip(&self.quadratic[nu][mu]).map(|(spin, entry)| spin * entry).sum::<f64>()
        })
    }

    /// Numbers that are not zero, symmetric ones counted once: what generated code of the body holds.
    pub fn nonzero_constants(&self) -> usize {
        let tensor = |tensor: &Symmetric| tensor.iter().filter(|x| **x != 0.0).count();
        let list = |numbers: &[f64]| numbers.iter().filter(|x| **x != 0.0).count();
        let matrix = |matrix: &ModalMatrix<HostModal, f64>| match matrix {
            ModalMatrix::Diagonal(diagonal) => list(diagonal.as_slice()),
            ModalMatrix::Dense(dense) => list(dense.as_slice()),
        };
        let modes = self.mode_count();
        let pairs = (0..modes).flat_map(|mu| (mu..modes).map(move |nu| (mu, nu)));
        let of_pairs: usize =
            pairs.map(|(mu, nu)| tensor(&self.quadratic[mu][nu]) + list(self.whirl[mu][nu].as_slice())).sum();
        1 + list(self.first_moment.as_slice())
            + self.modal_first_moment.iter().map(|row| list(row.as_slice())).sum::<usize>()
            + tensor(&self.inertia)
            + self.linear.iter().map(tensor).sum::<usize>()
            + self.rotation.iter().map(|vector| list(vector.as_slice())).sum::<usize>()
            + of_pairs
            + [&self.modal_mass, &self.stiffness, &self.damping].map(matrix).iter().sum::<usize>()
    }

    /// The markers of a model, in its order.
    pub fn markers(body: &ReducedBody) -> Vec<Marker<HostModal, f64>> {
        let rows = |list: &[[f64; 3]]| -> [HostModal; 3] {
            core::array::from_fn(|axis| {
                HostModal(DVector::from_iterator(list.len(), list.iter().map(|entry| entry[axis])))
            })
        };
        let stressing = |name: &str| {
            let geometric = body.geometric_stiffness.as_ref()?;
            geometric.marker_loads.iter().find(|load| load.marker == name)?;
            u16::try_from(body.markers.iter().position(|marker| marker.name == name)?).ok()
        };
        body.markers
            .iter()
            .map(|marker| Marker {
                position: marker.position.into(),
                translation: rows(&marker.translation),
                rotation: rows(&marker.rotation),
                stressing: stressing(&marker.name),
            })
            .collect()
    }
}

impl HostBody {
    /// The section markers of a model, in its order.
    pub fn section_markers(body: &ReducedBody) -> Vec<SectionMarker<HostModal, f64>> {
        let rows = |list: &[[f64; 6]], first: usize| -> [HostModal; 3] {
            core::array::from_fn(|axis| {
                HostModal(DVector::from_iterator(list.len(), list.iter().map(|entry| entry[first + axis])))
            })
        };
        let sections = body.section_markers.iter();
        sections
            .map(|marker| SectionMarker {
                position: marker.position.into(),
                force: rows(&marker.force, 0),
                moment: rows(&marker.force, 3),
            })
            .collect()
    }

    /// The stress markers of a model, in its order.
    pub fn stress_markers(body: &ReducedBody) -> Vec<StressMarker<HostModal, f64>> {
        let row = |list: &[[f64; 6]], component: usize| {
            HostModal(DVector::from_iterator(list.len(), list.iter().map(|entry| entry[component])))
        };
        body.stress_markers
            .iter()
            .map(|marker| StressMarker {
                position: marker.position.into(),
                stress: core::array::from_fn(|component| row(&marker.stress, component)),
            })
            .collect()
    }
}

impl<T: RealField + Copy> HostBody<T> {
    /// Number of modes.
    pub fn mode_count(&self) -> usize {
        self.linear.len()
    }
}

impl HostBody {
    /// The same body in another number type.
    pub fn cast<T: RealField + Copy>(&self) -> HostBody<T> {
        let tensor = |tensor: &Symmetric| tensor.map(convert);
        let vector = |vector: &Vector3<f64>| vector.map(convert);
        let pairs = |pairs: &[Vec<Vector3<f64>>]| -> Vec<Vec<Vector3<T>>> {
            pairs.iter().map(|row| row.iter().map(vector).collect()).collect()
        };
        HostBody {
            mass: convert(self.mass),
            first_moment: vector(&self.first_moment),
            modal_first_moment: self.modal_first_moment.each_ref().map(HostModal::cast),
            inertia: tensor(&self.inertia),
            linear: self.linear.iter().map(tensor).collect(),
            quadratic: self.quadratic.iter().map(|row| row.iter().map(tensor).collect()).collect(),
            rotation: self.rotation.iter().map(vector).collect(),
            whirl: self.whirl.iter().map(|row| row.iter().map(vector).collect()).collect(),
            second_order_rotation: pairs(&self.second_order_rotation),
            second_order_translation: pairs(&self.second_order_translation),
            marker_loads: self
                .marker_loads
                .iter()
                .map(|load| {
                    load.as_ref().map(|load| Box::new(load.each_ref().map(|matrix| matrix.map(convert))))
                })
                .collect(),
            modal_mass: cast_matrix(&self.modal_mass),
            stiffness: cast_matrix(&self.stiffness),
            damping: cast_matrix(&self.damping),
            is_stiffened: self.is_stiffened,
            largest_stable_step: self.largest_stable_step.map(convert),
        }
    }
}

impl<T: RealField + Copy> HostBody<T> {
    /// Γ of unit forces and moments at a marker of this [number](Marker::stressing), if the body has it. Shape: 6 x M x M.
    pub fn marker_load(&self, number: u16) -> Option<&[DMatrix<T>; 6]> {
        self.marker_loads.get(usize::from(number))?.as_deref()
    }
}

impl<T: RealField + Copy> FlexibleBody<T> for HostBody<T> {
    type Modal = HostModal<T>;

    fn undeformed(&self) -> HostModal<T> {
        HostModal::zeros(self.mode_count())
    }

    fn modal_mass(&self) -> ModalMatrix<HostModal<T>, T> {
        self.modal_mass.clone()
    }

    fn stiffness(&self) -> ModalMatrix<HostModal<T>, T> {
        self.stiffness.clone()
    }

    fn damping(&self) -> ModalMatrix<HostModal<T>, T> {
        self.damping.clone()
    }

    fn prepare(
        &self,
        q: &HostModal<T>,
        omega: &Vector3<T>,
        q_dot: &HostModal<T>,
    ) -> Prepared<HostModal<T>, T> {
        let (two, half): (T, T) = (convert(2.0), convert(0.5));
        let (coordinates, rates) = (q.as_slice(), q_dot.as_slice());
        let spin = spin_products(omega);
        let mut inertia = self.inertia;
        let mut inertia_rate = [T::zero(); 6];
        let mut coupling = [q.zeros_alike(), q.zeros_alike(), q.zeros_alike()];
        let mut modal_force = q.zeros_alike();
        let mut shortening = Vector3::zeros();
        for (mu, (linear, rotation)) in self.linear.iter().zip(&self.rotation).enumerate() {
            // Θ_μ + Θ_μᵀ + q_ν (Θ_νμ + Θ_μν), ϑ_μ + q_ν ϑ_νμ and q̇_ν ϑ_νμ
            let (mut even, mut odd, mut whirl) = (*linear, *rotation, Vector3::zeros());
            for nu in 0..coordinates.len() {
                for (sum, entry) in even.iter_mut().zip(&self.quadratic[nu][mu]) {
                    *sum += coordinates[nu] * *entry;
                }
                odd += self.whirl[nu][mu] * coordinates[nu];
                whirl += self.whirl[nu][mu] * rates[nu];
            }
            if let Some(row) = self.second_order_rotation.get(mu) {
                odd += combination(row, coordinates);
                shortening += combination(row, rates) * rates[mu];
            }
            for k in 0..6 {
                inertia[k] += half * coordinates[mu] * (linear[k] + even[k]);
                inertia_rate[k] += rates[mu] * even[k];
            }
            for axis in 0..3 {
                coupling[axis].as_mut_slice()[mu] = odd[axis];
            }
            let centrifugal = spin.iter().zip(&even).fold(T::zero(), |sum, (spin, even)| sum + *spin * *even);
            modal_force.as_mut_slice()[mu] = two * omega.dot(&whirl) - half * centrifugal;
        }
        let inertia = full(&inertia);
        let rows_times = |rows: &[HostModal<T>; 3], modal: &HostModal<T>| {
            Vector3::new(rows[0].dot(modal), rows[1].dot(modal), rows[2].dot(modal))
        };
        let mut modal_first_moment = self.modal_first_moment.clone();
        let mut first_moment = self.first_moment + rows_times(&self.modal_first_moment, q);
        let mut contraction = Vector3::zeros();
        for (mu, row) in self.second_order_translation.iter().enumerate() {
            let change = combination(row, coordinates);
            for axis in 0..3 {
                modal_first_moment[axis].as_mut_slice()[mu] += change[axis];
            }
            first_moment += change * (half * coordinates[mu]);
            contraction += combination(row, rates) * rates[mu];
        }
        let momentum = rows_times(&modal_first_moment, q_dot);
        let angular = inertia * omega + rows_times(&coupling, q_dot);
        let mut internal_force = self.stiffness.product(q);
        internal_force.add_scaled(T::one(), &self.damping.product(q_dot));
        Prepared {
            mass: self.mass,
            first_moment,
            inertia,
            modal_first_moment,
            rotation_modal_coupling: coupling,
            quadratic_velocity: GeneralisedForce {
                force: omega.cross(&(omega.cross(&first_moment) + momentum * two)) + contraction,
                moment: omega.cross(&angular) + full(&inertia_rate) * omega + shortening,
                modal: modal_force,
            },
            internal_force,
        }
    }

    fn is_stiffened(&self) -> bool {
        self.is_stiffened
    }

    fn bent_marker(
        &self,
        marker: &Marker<HostModal<T>, T>,
        q: &HostModal<T>,
    ) -> Option<Marker<HostModal<T>, T>> {
        let load = self.marker_load(marker.stressing?)?;
        let mut bent = marker.clone();
        for (row, stiffness) in bent.translation.iter_mut().chain(&mut bent.rotation).zip(load.iter()) {
            row.0 -= stiffness * &q.0;
        }
        Some(bent)
    }

    fn largest_stable_step(&self) -> Option<T> {
        self.largest_stable_step
    }
}

impl<T: RealField + Copy> Observables<T> for HostBody<T> {}

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

/// Σ_ν vector_ν c_ν
fn combination<T: RealField + Copy>(vectors: &[Vector3<T>], coefficients: &[T]) -> Vector3<T> {
    vectors.iter().zip(coefficients).fold(Vector3::zeros(), |sum, (vector, c)| sum + *vector * *c)
}

fn full<T: RealField + Copy>([xx, yy, zz, xy, xz, yz]: &Symmetric<T>) -> Matrix3<T> {
    Matrix3::new(*xx, *xy, *xz, *xy, *yy, *yz, *xz, *yz, *zz)
}

/// Factors of a symmetric tensor S in ω · S ω.
fn spin_products<T: RealField + Copy>(omega: &Vector3<T>) -> Symmetric<T> {
    let [x, y, z] = [omega.x, omega.y, omega.z];
    let two: T = convert(2.0);
    [x * x, y * y, z * z, two * x * y, two * x * z, two * y * z]
}

/// Diagonal if every other entry is zero.
fn matrix(modes: usize, entry: impl Fn(usize, usize) -> f64) -> ModalMatrix<HostModal, f64> {
    let dense = DMatrix::from_fn(modes, modes, entry);
    let diagonal = (0..modes).all(|mu| (0..modes).all(|nu| mu == nu || dense[(mu, nu)] == 0.0));
    if diagonal { ModalMatrix::Diagonal(HostModal(dense.diagonal())) } else { ModalMatrix::Dense(dense) }
}

fn cast_matrix<T: RealField + Copy>(matrix: &ModalMatrix<HostModal, f64>) -> ModalMatrix<HostModal<T>, T> {
    match matrix {
        ModalMatrix::Diagonal(diagonal) => ModalMatrix::Diagonal(diagonal.cast()),
        ModalMatrix::Dense(dense) => ModalMatrix::Dense(dense.map(convert)),
    }
}
