//! The bodies and states on which the equations are tested.

use std::sync::OnceLock;

use faer::sparse::Triplet;
use faer::{Mat, MatRef};
use ffrf_fe::SparseMatrix;
use ffrf_fe::formulations::gcms::{GeneralizedModes, apply_mass};
use ffrf_fe::formulations::null_space::{FloatingState, flexible_block, rotation_block};
use ffrf_fe::formulations::rotation::{directors, rotation_matrix};
use ffrf_test_kit::random::Random;

use crate::check::{self, column};
use crate::reference;

pub struct Body {
    pub name: String,
    /// How sharply identities and misprints show on this body.
    pub kind: Kind,
    pub positions: Vec<[f64; 3]>,
    pub shapes: Mat<f64>,
    pub mass: SparseMatrix,
    pub stiffness: SparseMatrix,
    pub modes: GeneralizedModes,
    /// M̄ of (56).
    pub reduced_mass: Mat<f64>,
    /// K̄ of (57).
    pub reduced_stiffness: Mat<f64>,
    /// T̄_μ and, row by row, T̄_μν, computed once.
    pub mode_moments: Vec<Mat<f64>>,
    pub pair_moments: Vec<Mat<f64>>,
}

/// What may be expected of a body.
#[derive(Clone, Copy, PartialEq)]
pub enum Kind {
    /// No symmetry: nothing vanishes, and every misprint shows.
    Unsymmetric,
    /// Free-free modes and symmetric shapes: some quantities vanish up to round-off, some misprints do not show.
    /// Unit mass, unit extent, unit largest modal displacement, so that every quantity has natural size 1.
    Symmetric,
}

impl Body {
    pub fn new(
        name: &str,
        positions: Vec<[f64; 3]>,
        shapes: Mat<f64>,
        mass: SparseMatrix,
        stiffness: SparseMatrix,
    ) -> Self {
        let modes = GeneralizedModes::new(&positions, shapes.as_ref());
        let reduced_mass = modes.reduced_mass(&mass);
        let reduced_stiffness = modes.reduced_stiffness(&stiffness);
        let mut body = Self {
            name: name.into(),
            kind: Kind::Unsymmetric,
            positions,
            shapes,
            mass,
            stiffness,
            modes,
            reduced_mass,
            reduced_stiffness,
            mode_moments: Vec::new(),
            pair_moments: Vec::new(),
        };
        let fields: Vec<_> = (0..body.mode_count()).map(|mu| body.phi_f(mu)).collect();
        let position = body.phi_r();
        body.mode_moments = fields.iter().map(|mode| body.mass_product(&position, mode)).collect();
        body.pair_moments = fields
            .iter()
            .flat_map(|a| fields.iter().map(|b| body.mass_product(a, b)).collect::<Vec<_>>())
            .collect();
        body
    }

    pub fn mode_count(&self) -> usize {
        self.modes.mode_count
    }

    /// φ_t (3N x 1), φ_r (3N x 3) of (118), φ_f,μ of (119): one coordinate direction only.
    pub fn one_direction(&self, field: impl Fn(usize) -> [f64; 3]) -> Mat<f64> {
        Mat::from_fn(3 * self.positions.len(), 3, |row, i| if row % 3 == 0 { field(row / 3)[i] } else { 0.0 })
    }

    pub fn phi_t(&self) -> Mat<f64> {
        Mat::from_fn(3 * self.positions.len(), 1, |row, _| if row % 3 == 0 { 1.0 } else { 0.0 })
    }

    pub fn phi_r(&self) -> Mat<f64> {
        self.one_direction(|node| self.positions[node])
    }

    pub fn phi_f(&self, mu: usize) -> Mat<f64> {
        self.one_direction(|node| [0, 1, 2].map(|i| self.shapes[(3 * node + i, mu)]))
    }

    /// aᵀ M b with the full mass matrix.
    pub fn mass_product(&self, a: &Mat<f64>, b: &Mat<f64>) -> Mat<f64> {
        a.transpose() * apply_mass(&self.mass, b.as_ref())
    }

    pub fn m(&self) -> f64 {
        self.mass_product(&self.phi_t(), &self.phi_t())[(0, 0)]
    }

    /// m ā of (120), corrected. Shape: 3 x 1.
    pub fn first_moment(&self) -> Mat<f64> {
        self.mass_product(&self.phi_r(), &self.phi_t())
    }

    /// m b̄_μ of (120). Shape: 3 x 1.
    pub fn modal_first_moment(&self, mu: usize) -> Mat<f64> {
        self.mass_product(&self.phi_f(mu), &self.phi_t())
    }

    /// T̄ of (126).
    pub fn t(&self) -> Mat<f64> {
        self.mass_product(&self.phi_r(), &self.phi_r())
    }

    /// T̄_μ of (127).
    pub fn t_mu(&self, mu: usize) -> Mat<f64> {
        self.mode_moments[mu].clone()
    }

    /// T̄_μν of (132).
    pub fn t_munu(&self, mu: usize, nu: usize) -> Mat<f64> {
        self.pair_moments[mu * self.mode_count() + nu].clone()
    }

    /// M_rr, M_tr, ... of (84): a block of M̄ by column ranges.
    pub fn m_block(&self, rows: Part, columns: Part) -> Mat<f64> {
        part_block(&self.reduced_mass, rows, columns)
    }

    pub fn k_block(&self, rows: Part, columns: Part) -> Mat<f64> {
        part_block(&self.reduced_stiffness, rows, columns)
    }
}

/// Translation, rotation, all flexible or one flexible mode's columns of the generalised modes.
#[derive(Clone, Copy)]
pub enum Part {
    T,
    R,
    F,
    Mode(usize),
}

fn part_block(matrix: &Mat<f64>, rows: Part, columns: Part) -> Mat<f64> {
    let range = |part| match part {
        Part::T => (0, 3),
        Part::R => (3, 9),
        Part::F => (12, matrix.nrows() - 12),
        Part::Mode(mu) => (12 + 9 * mu, 9),
    };
    let ((row, height), (col, width)) = (range(rows), range(columns));
    matrix.as_ref().submatrix(row, col, height, width).to_owned()
}

/// A state with its directors and projection blocks at hand.
pub struct State {
    pub floating: FloatingState,
    pub theta: [f64; 4],
    pub a: Mat<f64>,
    pub d: [[f64; 3]; 3],
    pub omega: Mat<f64>,
    pub q: Vec<f64>,
    pub q_dot: Vec<f64>,
    pub p_rr: Mat<f64>,
    pub p_ff: Mat<f64>,
}

impl State {
    pub fn new(theta: [f64; 4], omega: [f64; 3], q: Vec<f64>, q_dot: Vec<f64>) -> Self {
        let a = rotation_matrix(theta);
        let floating = FloatingState { rotation: a.clone(), omega, q: q.clone(), q_dot: q_dot.clone() };
        Self {
            theta,
            d: directors(a.as_ref()),
            omega: column(&omega),
            p_rr: rotation_block(a.as_ref()),
            p_ff: flexible_block(a.as_ref()),
            floating,
            a,
            q,
            q_dot,
        }
    }

    /// The three vectors q_μ1, q_μ2, q_μ3 of mode μ, (46).
    pub fn mode_triad(&self, mu: usize) -> [[f64; 3]; 3] {
        self.d.map(|d| d.map(|x| self.q[mu] * x))
    }

    /// v ↦ A v Aᵀ.
    pub fn rotate(&self, tensor: &Mat<f64>) -> Mat<f64> {
        &self.a * tensor * self.a.transpose()
    }
}

pub fn sparse(matrix: MatRef<'_, f64>) -> SparseMatrix {
    let entries: Vec<_> = (0..matrix.ncols())
        .flat_map(|j| (0..matrix.nrows()).map(move |i| (i, j)))
        .filter(|&ij| matrix[ij] != 0.0)
        .map(|(i, j)| Triplet::new(i, j, matrix[(i, j)]))
        .collect();
    SparseMatrix::try_new_from_triplets(matrix.nrows(), matrix.ncols(), &entries).expect("valid triplets")
}

/// Stiffness of bars between the given node pairs, Σ k t tᵀ: the truss of the appendix, for any number of nodes.
pub fn bars(positions: &[[f64; 3]], pairs: &[(usize, usize, f64)]) -> Mat<f64> {
    let mut k = Mat::zeros(3 * positions.len(), 3 * positions.len());
    for &(n, m, stiffness) in pairs {
        let along = [0, 1, 2].map(|i| positions[n][i] - positions[m][i]);
        let length = along.iter().map(|x| x * x).sum::<f64>().sqrt();
        for i in 0..3 {
            for j in 0..3 {
                let value = stiffness * along[i] * along[j] / (length * length);
                k[(3 * n + i, 3 * n + j)] += value;
                k[(3 * m + i, 3 * m + j)] += value;
                k[(3 * n + i, 3 * m + j)] -= value;
                k[(3 * m + i, 3 * n + j)] -= value;
            }
        }
    }
    k
}

fn unit_quaternion(random: &mut Random) -> [f64; 4] {
    let raw = [0; 4].map(|_| random.number());
    let norm = raw.iter().map(|x| x * x).sum::<f64>().sqrt();
    raw.map(|x| x / norm)
}

/// A body without any symmetry: dense mass, eccentric frame, modes that are not orthogonal.
pub fn random_body(mode_count: usize, seed: u64) -> Body {
    let mut random = Random::new(seed);
    let nodes = 9;
    let positions: Vec<_> = (0..nodes)
        .map(|_| random.vector())
        .map(|[x, y, z]| [x + 0.8, 0.7 * y - 0.4, 0.5 * z + 0.3])
        .collect();
    let root = Mat::from_fn(nodes, nodes, |i, j| if i == j { 1.5 } else { 0.4 * random.number() });
    let mass = &root * root.transpose();
    let shapes = Mat::from_fn(3 * nodes, mode_count, |_, _| random.number());
    let pairs: Vec<_> = (0..nodes)
        .flat_map(|n| (0..n).map(move |m| (n, m)))
        .map(|(n, m)| (n, m, 50.0 * (1.5 + random.number())))
        .collect();
    let stiffness = bars(&positions, &pairs);
    let name = format!("random body with {mode_count} modes");
    Body::new(&name, positions, shapes, sparse(mass.as_ref()), sparse(stiffness.as_ref()))
}

/// Three nodes and two bars, (218), with consistent bar masses; the modes are any two shapes.
pub fn truss() -> Body {
    let positions = vec![[0.2, 0.1, -0.3], [1.0, 0.6, 0.1], [1.8, -0.5, 0.7]];
    let stiffness = bars(&positions, &[(0, 1, 300.0), (1, 2, 220.0)]);
    let mass = [[0.5, 0.25, 0.0], [0.25, 1.2, 0.35], [0.0, 0.35, 0.7]];
    let mass = Mat::from_fn(3, 3, |i, j| mass[i][j]);
    let mut random = Random::new(5);
    let shapes = Mat::from_fn(9, 2, |_, _| random.number());
    Body::new("truss of three nodes", positions, shapes, sparse(mass.as_ref()), sparse(stiffness.as_ref()))
}

/// Runs a test on every body in several states: large rotations, displacements up to 0.3 of the body.
pub fn each_state(mut test: impl FnMut(&Body, &State)) {
    for (index, body) in all().iter().enumerate() {
        let mut random = Random::new(100 + index as u64);
        let size = body.positions.iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs()));
        let states = if body.positions.len() < 20 { 4 } else { 1 };
        check::judge_for(body.kind);
        for _ in 0..states {
            let theta = unit_quaternion(&mut random);
            let omega = random.vector().map(|x| 2.0 * x);
            let raw: Vec<f64> = (0..body.mode_count()).map(|_| random.number()).collect();
            let q_dot: Vec<f64> = (0..body.mode_count()).map(|_| random.number()).collect();
            let displacement = (&body.shapes * column(&raw)).norm_max();
            let q = raw.iter().map(|x| 0.3 * size / displacement * x).collect();
            let state = State::new(theta, omega, q, q_dot);
            println!("{}, theta {theta:?}", body.name);
            test(body, &state);
        }
    }
    check::judge_for(Kind::Unsymmetric);
}

/// Runs a test on every body.
pub fn each_body(mut test: impl FnMut(&Body)) {
    for body in all() {
        println!("{}", body.name);
        check::judge_for(body.kind);
        test(body);
    }
    check::judge_for(Kind::Unsymmetric);
}

fn all() -> &'static [Body] {
    static BODIES: OnceLock<Vec<Body>> = OnceLock::new();
    BODIES.get_or_init(|| {
        let mut bodies = vec![truss()];
        bodies.extend([(1, 11), (2, 12), (3, 13), (5, 15)].map(|(modes, seed)| random_body(modes, seed)));
        bodies.extend(reference::bodies());
        bodies
    })
}
