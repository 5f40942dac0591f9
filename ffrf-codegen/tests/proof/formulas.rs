//! The corrected Section 8 of the paper, transcribed line by line, with a switch that puts a misprint back.

use ffrf_codegen::body::RawInertia;
use ffrf_codegen::expression::{Expression, Graph, Input, Vector, cross, dot, sum3};

type Matrix = [Vector; 3];

/// A misprint of the paper (`docs/theory/errata.md`) that changes mass matrix or quadratic velocity vector.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Misprint {
    /// (151), (163), (203): M_tr = + m r~.
    MassCouplingSign,
    /// (163), (204): r = a - q_μ b_μ.
    FirstMomentSign,
    /// (163), (204): Θ_rr with 2 q_μ Θ_μ.
    TwiceTheta,
    /// (136), (207): Θ_μ = tr(T_μ) I - T_μ.
    ModeInertiaTransposed,
    /// (138), (207): Θ_μν = tr(T_μν) I - T_μν.
    ModeModeInertiaTransposed,
    /// (180), (205): Θ_μ^d = Θ_μ + q_ν Θ_μν.
    IndexOrder,
    /// (207) and (180) both as printed: they cancel partly.
    TransposedAndIndexOrder,
    /// (165): Θ_rf,μ = ϑ_μ + q_ν ϑ_μν.
    CouplingIndexOrder,
    /// (209): + 2 ω·ϑ_μν q̇_ν in Q_f.
    CoriolisSign,
    /// (78): axial vector without ½, used in (208).
    AxialFactor,
    /// (143), (208): ϑ~ = Θ - Θᵀ with the true Θ.
    SkewSign,
    /// (175), first form: ω × (Θ ω).
    UndeformedGyroscopic,
    /// A slip of our own: Q_r with Θ_μ^dᵀ.
    TransposedInProduct,
    /// A slip of our own: ω × r × ω instead of ω × (ω × r).
    CentripetalSign,
}

impl Misprint {
    pub const ALL: [Self; 14] = [
        Self::MassCouplingSign,
        Self::FirstMomentSign,
        Self::TwiceTheta,
        Self::ModeInertiaTransposed,
        Self::ModeModeInertiaTransposed,
        Self::IndexOrder,
        Self::TransposedAndIndexOrder,
        Self::CouplingIndexOrder,
        Self::CoriolisSign,
        Self::AxialFactor,
        Self::SkewSign,
        Self::UndeformedGyroscopic,
        Self::TransposedInProduct,
        Self::CentripetalSign,
    ];

    /// The number of modes from which on the misprint can be seen at all.
    pub fn visible_from(self) -> usize {
        match self {
            Self::MassCouplingSign | Self::CentripetalSign => 0,
            Self::CoriolisSign | Self::IndexOrder | Self::CouplingIndexOrder => 2,
            // T_11 is symmetric: its transpose shows from two modes on.
            Self::ModeModeInertiaTransposed => 2,
            _ => 1,
        }
    }
}

/// Mass matrix and quadratic velocity vector.
pub struct Formulas {
    pub mass_matrix: Vec<Vec<Expression>>,
    pub quadratic_velocity: Vec<Expression>,
}

/// A graph with a misprint: the formulas read like the equations.
struct Writer<'a> {
    graph: &'a mut Graph,
    misprint: Option<Misprint>,
}

impl Writer<'_> {
    fn has(&self, misprint: Misprint) -> bool {
        self.misprint == Some(misprint)
    }

    /// tr(T) I - Tᵀ, or with `printed` tr(T) I - T.
    fn inertia(&mut self, t: &Matrix, printed: bool) -> Matrix {
        let trace = self.graph.sum([t[0][0], t[1][1], t[2][2]]);
        let zero = self.graph.zero();
        entries(|i, j| {
            let moment = if printed { t[i][j] } else { t[j][i] };
            self.graph.subtract(if i == j { trace } else { zero }, moment)
        })
    }

    /// ϑ = ε_ijk T^{ij} e_k
    fn spin(&mut self, t: &Matrix) -> Vector {
        let spin = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| self.graph.subtract(t[i][j], t[j][i]));
        if self.has(Misprint::AxialFactor) {
            self.scaled(2.0, spin)
        } else if self.has(Misprint::SkewSign) {
            self.scaled(-1.0, spin)
        } else {
            spin
        }
    }

    /// ϑ = ε_ijk T^{ij} e_k, whatever the paper prints.
    fn axial(&mut self, t: &Matrix) -> Vector {
        [(1, 2), (2, 0), (0, 1)].map(|(i, j)| self.graph.subtract(t[i][j], t[j][i]))
    }

    fn scaled(&mut self, factor: f64, a: Vector) -> Vector {
        a.map(|component| self.graph.scale(factor, component))
    }

    fn times(&mut self, factor: Expression, a: Vector) -> Vector {
        a.map(|component| self.graph.multiply(factor, component))
    }

    /// start + factor * matrix
    fn add_matrix(&mut self, start: Matrix, factor: Expression, matrix: &Matrix) -> Matrix {
        entries(|i, j| self.graph.sum_of_products(start[i][j], [(factor, matrix[i][j])]))
    }

    fn product(&mut self, matrix: &Matrix, a: Vector) -> Vector {
        [0, 1, 2].map(|i| dot(self.graph, matrix[i], a))
    }
}

fn entries(mut entry: impl FnMut(usize, usize) -> Expression) -> Matrix {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)))
}

/// ½ (Θ + Θᵀ): the part that ω · Θ ω knows.
fn symmetric_part(w: &mut Writer<'_>, theta: &Matrix) -> Matrix {
    entries(|i, j| {
        let sum = w.graph.add(theta[i][j], theta[j][i]);
        w.graph.scale(0.5, sum)
    })
}

fn transpose(matrix: &Matrix) -> Matrix {
    entries(|i, j| matrix[j][i])
}

/// (203)-(209) as corrected, or with one misprint.
pub fn write(graph: &mut Graph, inertia: &RawInertia, misprint: Option<Misprint>) -> Formulas {
    let mut w = Writer { graph, misprint };
    let modes = inertia.mode_count();
    let omega = [0, 1, 2].map(|i| w.graph.symbol(Input::ANGULAR_VELOCITY.symbol(i)));
    let q: Vec<_> = (0..modes).map(|mu| w.graph.symbol(Input::COORDINATES.symbol(mu))).collect();
    let q_dot: Vec<_> = (0..modes).map(|mu| w.graph.symbol(Input::RATES.symbol(mu))).collect();
    let zero = w.graph.zero();

    // Constant matrices (207), (208)
    let both = w.has(Misprint::TransposedAndIndexOrder);
    let theta = w.inertia(&inertia.second_moment, false);
    let printed = both || w.has(Misprint::ModeInertiaTransposed);
    let theta_mode: Vec<_> = inertia.position_mode_moment.iter().map(|t| w.inertia(t, printed)).collect();
    let printed = both || w.has(Misprint::ModeModeInertiaTransposed);
    let theta_mode_mode: Vec<Vec<_>> = (inertia.mode_mode_moment.iter())
        .map(|row| row.iter().map(|t| w.inertia(t, printed)).collect())
        .collect();
    let spin_mode: Vec<_> = inertia.position_mode_moment.iter().map(|t| w.spin(t)).collect();
    let spin_mode_mode: Vec<Vec<_>> =
        inertia.mode_mode_moment.iter().map(|row| row.iter().map(|t| w.spin(t)).collect()).collect();

    // Second-order moments: the stress stiffness of unit loads with the opposite sign
    let second_theta: Vec<Vec<_>> = (inertia.linear_load_stiffness.iter())
        .map(|row| row.iter().map(|t| w.inertia(t, false)).collect())
        .collect();
    let second_spin: Vec<Vec<_>> =
        inertia.linear_load_stiffness.iter().map(|row| row.iter().map(|t| w.axial(t)).collect()).collect();
    let second_first = &inertia.uniform_load_stiffness;
    let minus_one = w.graph.constant(-1.0);

    // (204): m r, Θ_rr, Θ_rf; (205): Θ_μ^d
    let mut first_moment = inertia.first_moment;
    let mut theta_rr = theta;
    let mut theta_rf = Vec::new();
    let mut theta_d = Vec::new();
    let mut modal_momentum = [zero; 3];
    let mut modal_first = inertia.modal_first_moment.clone();
    let (mut contraction, mut shortening) = ([zero; 3], [zero; 3]);
    for mu in 0..modes {
        let sign = if w.has(Misprint::FirstMomentSign) { -1.0 } else { 1.0 };
        let signed = w.scaled(sign, inertia.modal_first_moment[mu]);
        let part = w.times(q[mu], signed);
        first_moment = sum3(w.graph, first_moment, part);
        theta_rr = w.add_matrix(theta_rr, q[mu], &theta_mode[mu]);
        let other = if w.has(Misprint::TwiceTheta) { theta_mode[mu] } else { transpose(&theta_mode[mu]) };
        theta_rr = w.add_matrix(theta_rr, q[mu], &other);
        let mut coupling = spin_mode[mu];
        let mut deformed = theta_mode[mu];
        for nu in 0..modes {
            let product = w.graph.multiply(q[mu], q[nu]);
            theta_rr = w.add_matrix(theta_rr, product, &theta_mode_mode[mu][nu]);
            let swapped = w.has(Misprint::CouplingIndexOrder);
            let spin = if swapped { spin_mode_mode[mu][nu] } else { spin_mode_mode[nu][mu] };
            let part = w.times(q[nu], spin);
            coupling = sum3(w.graph, coupling, part);
            let swapped = both || w.has(Misprint::IndexOrder);
            let inertia = if swapped { theta_mode_mode[mu][nu] } else { theta_mode_mode[nu][mu] };
            deformed = w.add_matrix(deformed, q[nu], &inertia);

            // What stress stiffness adds: in Θ_rr, Θ_rf and Θ_μ^d as T_νμ does, in m r and m B as b_μ does
            let product = w.graph.multiply(minus_one, product);
            let symmetric = symmetric_part(&mut w, &second_theta[mu][nu]);
            theta_rr = w.add_matrix(theta_rr, product, &symmetric);
            let half = w.graph.scale(0.5, product);
            let part = w.times(half, second_first[mu][nu]);
            first_moment = sum3(w.graph, first_moment, part);
            let minus_q = w.graph.negate(q[nu]);
            let part = w.times(minus_q, second_spin[mu][nu]);
            coupling = sum3(w.graph, coupling, part);
            deformed = w.add_matrix(deformed, minus_q, &second_theta[mu][nu]);
            let part = w.times(minus_q, second_first[mu][nu]);
            modal_first[mu] = sum3(w.graph, modal_first[mu], part);
            // and the accelerations that steady rates leave
            let rates = w.graph.multiply(q_dot[mu], q_dot[nu]);
            let minus_rates = w.graph.negate(rates);
            let part = w.times(minus_rates, second_first[mu][nu]);
            contraction = sum3(w.graph, contraction, part);
            let part = w.times(minus_rates, second_spin[mu][nu]);
            shortening = sum3(w.graph, shortening, part);
        }
        let part = w.times(q_dot[mu], modal_first[mu]);
        modal_momentum = sum3(w.graph, modal_momentum, part);
        theta_rf.push(coupling);
        theta_d.push(deformed);
    }

    // (203): the mass matrix
    let size = 6 + modes;
    let mut mass_matrix = vec![vec![zero; size]; size];
    let sign = if w.has(Misprint::MassCouplingSign) { 1.0 } else { -1.0 };
    for i in 0..3 {
        mass_matrix[i][i] = inertia.mass;
        // (r~)_ij = - ε_ijk r_k
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let coupling = w.graph.scale(-sign, first_moment[k]);
        let opposite = w.graph.negate(coupling);
        mass_matrix[i][3 + j] = coupling;
        mass_matrix[j][3 + i] = opposite;
        mass_matrix[3 + j][i] = coupling;
        mass_matrix[3 + i][j] = opposite;
        for j in 0..3 {
            mass_matrix[3 + i][3 + j] = theta_rr[i][j];
        }
        for mu in 0..modes {
            mass_matrix[i][6 + mu] = modal_first[mu][i];
            mass_matrix[6 + mu][i] = modal_first[mu][i];
            mass_matrix[3 + i][6 + mu] = theta_rf[mu][i];
            mass_matrix[6 + mu][3 + i] = theta_rf[mu][i];
        }
    }
    for mu in 0..modes {
        for nu in 0..modes {
            mass_matrix[6 + mu][6 + nu] = inertia.modal_mass[mu][nu];
        }
    }

    // Q_t = m ω × (ω × r) + 2 m ω × (B q̇)
    let inner = cross(w.graph, omega, first_moment);
    let centripetal = cross(w.graph, omega, inner);
    let sign = if w.has(Misprint::CentripetalSign) { -1.0 } else { 1.0 };
    let centripetal = w.scaled(sign, centripetal);
    let coriolis = cross(w.graph, omega, modal_momentum);
    let coriolis = w.scaled(2.0, coriolis);
    let translation = sum3(w.graph, centripetal, coriolis);
    let translation = sum3(w.graph, translation, contraction);
    // Q_r = ω × (Θ_rr ω) + 2 q̇_μ Θ_μ^d ω
    let gyroscopic = if w.has(Misprint::UndeformedGyroscopic) { theta } else { theta_rr };
    let spin = w.product(&gyroscopic, omega);
    let rotation = cross(w.graph, omega, spin);
    let mut rotation = sum3(w.graph, rotation, shortening);
    let mut modal = Vec::new();
    for mu in 0..modes {
        let flip = w.has(Misprint::TransposedInProduct);
        let matrix = if flip { transpose(&theta_d[mu]) } else { theta_d[mu] };
        let product = w.product(&matrix, omega);
        let twice = w.graph.scale(2.0, q_dot[mu]);
        let part = w.times(twice, product);
        rotation = sum3(w.graph, rotation, part);
        // Q_f,μ = - ω·Θ_μ^d ω + 2 q̇_ν ω·ϑ_νμ
        let centrifugal = dot(w.graph, omega, product);
        let mut force = w.graph.negate(centrifugal);
        for nu in 0..modes {
            let swapped = w.has(Misprint::CoriolisSign);
            let spin = if swapped { spin_mode_mode[mu][nu] } else { spin_mode_mode[nu][mu] };
            let projection = dot(w.graph, omega, spin);
            let twice = w.graph.scale(2.0, q_dot[nu]);
            force = w.graph.sum_of_products(force, [(twice, projection)]);
        }
        modal.push(force);
    }
    let quadratic_velocity = translation.into_iter().chain(rotation).chain(modal).collect();
    Formulas { mass_matrix, quadratic_velocity }
}
