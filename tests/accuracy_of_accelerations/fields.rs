//! Bodies of point masses with displacement fields as modes: their invariants are Gram matrices, hence consistent.

use ffrf::nalgebra::{DMatrix, Matrix3, Vector3};
use ffrf_model::{Inertia, Mode, ModeKind, Provenance, ReducedBody, SCHEMA_VERSION};

use ffrf_test_kit::random::Random;

/// One displacement field: a vector per node.
pub type Field = Vec<Vector3<f64>>;

/// Point masses and their modes.
pub struct Fields {
    pub masses: Vec<f64>,
    pub positions: Field,
    pub modes: Vec<Field>,
}

impl Fields {
    /// Random masses and nodes in a block of 1 by `thickness` by `thickness`, without modes.
    pub fn nodes(random: &mut Random, count: usize, thickness: f64) -> Self {
        let masses = (0..count).map(|_| 0.6 + 0.4 * random.number()).collect();
        let positions = (0..count)
            .map(|_| Vector3::new(random.number(), thickness * random.number(), thickness * random.number()))
            .collect();
        Self { masses, positions, modes: Vec::new() }
    }

    /// A field of random displacements.
    pub fn random_field(&self, random: &mut Random) -> Field {
        self.masses.iter().map(|_| Vector3::new(random.number(), random.number(), random.number())).collect()
    }

    /// A field by its formula in the position.
    pub fn field(&self, formula: impl Fn(&Vector3<f64>) -> Vector3<f64>) -> Field {
        self.positions.iter().map(formula).collect()
    }

    /// Σ m a · b
    pub fn product(&self, a: &Field, b: &Field) -> f64 {
        self.masses.iter().zip(a.iter().zip(b)).map(|(m, (a, b))| m * a.dot(b)).sum()
    }

    /// The field times a factor, so that its mass is that of the body.
    pub fn scaled(&self, field: &Field) -> Field {
        let total: f64 = self.masses.iter().sum();
        let factor = (total / self.product(field, field)).sqrt();
        field.iter().map(|u| u * factor).collect()
    }

    /// Makes the modes orthonormal in the mass: Gram-Schmidt, three times over.
    pub fn orthonormalise(&mut self) {
        let mut modes: Vec<Field> = Vec::new();
        for mode in &self.modes {
            let mut field = mode.clone();
            for _ in 0..3 {
                for known in &modes {
                    let factor = self.product(known, &field);
                    for (u, k) in field.iter_mut().zip(known) {
                        *u -= k * factor;
                    }
                }
                let length = self.product(&field, &field).sqrt();
                field.iter_mut().for_each(|u| *u /= length);
            }
            modes.push(field);
        }
        self.modes = modes;
    }

    /// Each mode replaced by a combination of all: rows of `weights`.
    pub fn combine(&mut self, weights: &DMatrix<f64>) {
        let combined = |row: usize| -> Field {
            let mut field = vec![Vector3::zeros(); self.masses.len()];
            for (mode, weight) in self.modes.iter().zip(weights.row(row).iter()) {
                for (u, v) in field.iter_mut().zip(mode) {
                    *u += v * *weight;
                }
            }
            field
        };
        self.modes = (0..weights.nrows()).map(combined).collect();
    }

    /// Positions and modes mapped by `map`.
    pub fn map(&mut self, map: impl Fn(&Vector3<f64>) -> Vector3<f64>) {
        for field in self.modes.iter_mut().chain([&mut self.positions]) {
            field.iter_mut().for_each(|u| *u = map(u));
        }
    }

    /// The reduced body, with stiffness and damping of modes that swing at up to 30 rad/s.
    pub fn body(&self) -> ReducedBody {
        let moment = |a: &Field, b: &Field| -> Matrix3<f64> {
            self.masses.iter().zip(a.iter().zip(b)).map(|(m, (a, b))| a * b.transpose() * *m).sum()
        };
        let rows = |m: &Matrix3<f64>| [0, 1, 2].map(|i| [0, 1, 2].map(|j| m[(i, j)]));
        let first = |a: &Field| -> [f64; 3] {
            self.masses.iter().zip(a).map(|(m, a)| a * *m).sum::<Vector3<f64>>().into()
        };
        let count = self.modes.len();
        let mut mode_mode = vec![vec![Matrix3::zeros(); count]; count];
        for mu in 0..count {
            for nu in 0..mu {
                mode_mode[mu][nu] = moment(&self.modes[mu], &self.modes[nu]);
                mode_mode[nu][mu] = mode_mode[mu][nu].transpose();
            }
            mode_mode[mu][mu] = symmetric(moment(&self.modes[mu], &self.modes[mu]));
        }
        let diagonal = |factor: &dyn Fn(usize) -> f64| -> Vec<Vec<f64>> {
            let entry = |mu: usize| factor(mu) * mode_mode[mu][mu].trace();
            (0..count)
                .map(|mu| (0..count).map(|nu| if mu == nu { entry(mu) } else { 0.0 }).collect())
                .collect()
        };
        let frequency = |mu: usize| 3.0 + 27.0 * mu as f64 / count as f64;
        ReducedBody {
            schema_version: SCHEMA_VERSION,
            title: "body of point masses".to_owned(),
            units: "m, kg, s, N".to_owned(),
            provenance: Provenance {
                tool: "ffrf".to_owned(),
                tool_version: "0.1.0".to_owned(),
                sources: Vec::new(),
                notes: Vec::new(),
            },
            modes: vec![Mode { kind: ModeKind::User, frequency_hz: None }; count],
            inertia: Inertia {
                mass: self.masses.iter().sum(),
                first_moment: first(&self.positions),
                modal_first_moment: self.modes.iter().map(first).collect(),
                second_moment: rows(&symmetric(moment(&self.positions, &self.positions))),
                position_mode_moment: self
                    .modes
                    .iter()
                    .map(|mode| rows(&moment(&self.positions, mode)))
                    .collect(),
                mode_mode_moment: mode_mode.iter().map(|row| row.iter().map(rows).collect()).collect(),
            },
            stiffness: diagonal(&|mu| frequency(mu).powi(2)),
            damping: diagonal(&|mu| 0.02 * frequency(mu)),
            geometric_stiffness: None,
            second_order_terms: Default::default(),
            stress_markers: Vec::new(),
            section_markers: Vec::new(),
            markers: Vec::new(),
        }
    }
}

/// Without the rounding that tells the triangles apart.
fn symmetric(matrix: Matrix3<f64>) -> Matrix3<f64> {
    (matrix + matrix.transpose()) * 0.5
}
