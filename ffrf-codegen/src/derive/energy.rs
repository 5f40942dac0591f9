//! The kinetic energy, the single source of truth.

use crate::expression::{Expression, Graph, Symbol, Vector, cross, dot, sum3};
use crate::fidelity::{EnergyTerm, Fidelity};

/// Rows of a 3 x 3 matrix of expressions.
pub type Matrix = [Vector; 3];

/// The raw invariants (206), (207) of a body with M modes: symbols, constants or zeros, as full matrices.
///
/// Frame: body, about its origin. Units: the invariants' own (kg, kg m, kg m^2 for unit modes).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RawInertia {
    /// Mass m.
    pub mass: Expression,
    /// First moment m a. Shape: 3.
    pub first_moment: Vector,
    /// Modal first moments m b_μ. Shape: M x 3.
    pub modal_first_moment: Vec<Vector>,
    /// Second moment T^{ij} = ∫ρ xⁱ xʲ. Shape: 3 x 3, symmetric.
    pub second_moment: Matrix,
    /// Position-mode moments T_μ^{ij} = ∫ρ xⁱ φ_μʲ. Shape: M x 3 x 3.
    pub position_mode_moment: Vec<Matrix>,
    /// Mode-mode moments T_μν^{ij} = ∫ρ φ_μⁱ φ_νʲ. Shape: M x M x 3 x 3, T_νμ = T_μνᵀ.
    pub mode_mode_moment: Vec<Vec<Matrix>>,
    /// Modal mass Θ_ff. Shape: M x M.
    pub modal_mass: Vec<Vec<Expression>>,
}

impl RawInertia {
    /// Number of modes M.
    pub fn mode_count(&self) -> usize {
        self.modal_first_moment.len()
    }

    /// Every invariant a symbol of its own; Θ_ff = [tr T_μν].
    pub fn dense(graph: &mut Graph, mode_count: usize) -> Self {
        let modes = 0..mode_count;
        let second_moment = matrix(|i, j| graph.symbol(Symbol::SecondMoment(i.min(j), i.max(j))));
        let position_mode_moment: Vec<Matrix> = modes
            .clone()
            .map(|mu| matrix(|i, j| graph.symbol(Symbol::PositionModeMoment(mu, i, j))))
            .collect();
        let mode_mode_moment: Vec<Vec<Matrix>> = modes
            .clone()
            .map(|mu| modes.clone().map(|nu| matrix(|i, j| mode_mode_symbol(graph, mu, nu, i, j))).collect())
            .collect();
        let modal_mass =
            mode_mode_moment.iter().map(|row| row.iter().map(|t| trace(graph, t)).collect()).collect();
        Self {
            mass: graph.symbol(Symbol::Mass),
            first_moment: [0, 1, 2].map(|i| graph.symbol(Symbol::FirstMoment(i))),
            modal_first_moment: modes
                .map(|mu| [0, 1, 2].map(|i| graph.symbol(Symbol::ModalFirstMoment(mu, i))))
                .collect(),
            second_moment,
            position_mode_moment,
            mode_mode_moment,
            modal_mass,
        }
    }
}

/// The symbol of T_μν^{ij}, the same for T_νμ^{ji}.
fn mode_mode_symbol(graph: &mut Graph, mu: usize, nu: usize, i: usize, j: usize) -> Expression {
    let swap = mu > nu || (mu == nu && i > j);
    graph.symbol(if swap {
        Symbol::ModeModeMoment(nu, mu, j, i)
    } else {
        Symbol::ModeModeMoment(mu, nu, i, j)
    })
}

/// The kinetic energy as a sum of named terms.
///
/// Units: J. Source: `docs/theory/README.md`, E; [`EnergyTerm`] has the formulas.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KineticEnergy {
    terms: [(EnergyTerm, Expression); 9],
}

impl KineticEnergy {
    /// Writes every term in the symbols v ([`Symbol::Velocity`]), ω ([`Symbol::AngularVelocity`]),
    /// q ([`Symbol::Coordinate`]) and q̇ ([`Symbol::Rate`]).
    pub fn new(graph: &mut Graph, inertia: &RawInertia) -> Self {
        let modes = 0..inertia.mode_count();
        let v = [0, 1, 2].map(|i| graph.symbol(Symbol::Velocity(i)));
        let omega = [0, 1, 2].map(|i| graph.symbol(Symbol::AngularVelocity(i)));
        let q: Vec<_> = modes.clone().map(|mu| graph.symbol(Symbol::Coordinate(mu))).collect();
        let q_dot: Vec<_> = modes.map(|mu| graph.symbol(Symbol::Rate(mu))).collect();

        let v_squared = dot(graph, v, v);
        let translation = graph.multiply(inertia.mass, v_squared);
        let omega_cross_first = cross(graph, omega, inertia.first_moment);
        let theta = inertia_matrix(graph, &inertia.second_moment);
        let rotation = quadratic_form(graph, omega, &theta);

        let mut terms = EnergyTerm::ALL.map(|term| (term, graph.zero()));
        let mut add = |graph: &mut Graph, term: EnergyTerm, expression: Expression| {
            for (_, sum) in terms.iter_mut().filter(|(known, _)| *known == term) {
                *sum = graph.add(*sum, expression);
            }
        };
        // ½ m v·v, v·(ω × m a), ½ ω·Θ ω
        let half = graph.scale(0.5, translation);
        add(graph, EnergyTerm::Translation, half);
        let eccentric = dot(graph, v, omega_cross_first);
        add(graph, EnergyTerm::FirstMoment, eccentric);
        let half = graph.scale(0.5, rotation);
        add(graph, EnergyTerm::Rotation, half);

        for mu in 0..inertia.mode_count() {
            // v·(ω × m q_μ b_μ + m b_μ q̇_μ)
            let b = inertia.modal_first_moment[mu];
            let moment = b.map(|component| graph.multiply(q[mu], component));
            let carried = cross(graph, omega, moment);
            let own = b.map(|component| graph.multiply(q_dot[mu], component));
            let rate = sum3(graph, carried, own);
            let expression = dot(graph, v, rate);
            add(graph, EnergyTerm::ModalMomentum, expression);
            // q_μ ω·Θ_μ ω
            let theta = inertia_matrix(graph, &inertia.position_mode_moment[mu]);
            let form = quadratic_form(graph, omega, &theta);
            let expression = graph.multiply(q[mu], form);
            add(graph, EnergyTerm::RotationLinear, expression);
            // ω·ϑ_μ q̇_μ
            let expression = spin(graph, omega, &inertia.position_mode_moment[mu], q_dot[mu]);
            add(graph, EnergyTerm::ModalRotation, expression);
            for nu in 0..inertia.mode_count() {
                // ½ q_μ q_ν ω·Θ_μν ω
                let theta = inertia_matrix(graph, &inertia.mode_mode_moment[mu][nu]);
                let form = quadratic_form(graph, omega, &theta);
                let coordinates = graph.multiply(q[mu], q[nu]);
                let product = graph.multiply(coordinates, form);
                let expression = graph.scale(0.5, product);
                add(graph, EnergyTerm::RotationQuadratic, expression);
                // q_ν ω·ϑ_νμ q̇_μ
                let product = spin(graph, omega, &inertia.mode_mode_moment[nu][mu], q_dot[mu]);
                let expression = graph.multiply(q[nu], product);
                add(graph, EnergyTerm::ModalRotationDeformed, expression);
                // ½ q̇_μ Θ_ff,μν q̇_ν
                let rates = graph.multiply(q_dot[mu], q_dot[nu]);
                let product = graph.multiply(rates, inertia.modal_mass[mu][nu]);
                let expression = graph.scale(0.5, product);
                add(graph, EnergyTerm::Modal, expression);
            }
        }
        Self { terms }
    }

    /// The terms, in the order in which the energy is written.
    pub fn terms(&self) -> &[(EnergyTerm, Expression)] {
        &self.terms
    }

    /// The sum of the terms that `fidelity` keeps.
    pub fn truncated(&self, graph: &mut Graph, fidelity: &Fidelity) -> Expression {
        graph.sum(self.terms.iter().filter(|(term, _)| fidelity.keeps(*term)).map(|(_, value)| *value))
    }
}

/// The matrix with the given entries.
fn matrix(mut entry: impl FnMut(usize, usize) -> Expression) -> Matrix {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)))
}

/// tr T
fn trace(graph: &mut Graph, moment: &Matrix) -> Expression {
    graph.sum([moment[0][0], moment[1][1], moment[2][2]])
}

/// Θ = tr(T) I - Tᵀ (207)
fn inertia_matrix(graph: &mut Graph, moment: &Matrix) -> Matrix {
    let trace = trace(graph, moment);
    let zero = graph.zero();
    matrix(|i, j| graph.subtract(if i == j { trace } else { zero }, moment[j][i]))
}

/// ω·Θ ω
fn quadratic_form(graph: &mut Graph, omega: Vector, theta: &Matrix) -> Expression {
    let product = [0, 1, 2].map(|i| dot(graph, theta[i], omega));
    dot(graph, omega, product)
}

/// ω·ϑ q̇ with ϑ = ε_ijk T^{ij} e_k (208)
fn spin(graph: &mut Graph, omega: Vector, moment: &Matrix, rate: Expression) -> Expression {
    let theta = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| graph.subtract(moment[i][j], moment[j][i]));
    let projection = dot(graph, omega, theta);
    graph.multiply(projection, rate)
}
