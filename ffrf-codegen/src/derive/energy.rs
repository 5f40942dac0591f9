//! The kinetic energy, the single source of truth.

use crate::body::{Matrix, RawInertia, matrix, trace};
use crate::expression::{Expression, Graph, Input, Vector, cross, dot, sum3};
use crate::fidelity::{EnergyTerm, Fidelity};

/// The kinetic energy as a sum of named terms.
///
/// Units: J. Source: `docs/theory/README.md`, E; [`EnergyTerm`] has the formulas.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KineticEnergy {
    terms: [(EnergyTerm, Expression); 12],
}

impl KineticEnergy {
    /// Writes every term in the symbols v ([`Input::VELOCITY`]), ω ([`Input::ANGULAR_VELOCITY`]),
    /// q ([`Input::COORDINATES`]) and q̇ ([`Input::RATES`]).
    pub fn new(graph: &mut Graph, inertia: &RawInertia) -> Self {
        let modes = 0..inertia.mode_count();
        let v = [0, 1, 2].map(|i| graph.symbol(Input::VELOCITY.symbol(i)));
        let omega = [0, 1, 2].map(|i| graph.symbol(Input::ANGULAR_VELOCITY.symbol(i)));
        let q: Vec<_> = modes.clone().map(|mu| graph.symbol(Input::COORDINATES.symbol(mu))).collect();
        let q_dot: Vec<_> = modes.map(|mu| graph.symbol(Input::RATES.symbol(mu))).collect();

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
                // -½ q_μ q_ν ω·Θ(Γ_μν) ω
                let stiffness = &inertia.linear_load_stiffness[mu][nu];
                let theta = inertia_matrix(graph, stiffness);
                let form = quadratic_form(graph, omega, &theta);
                let product = graph.multiply(coordinates, form);
                let expression = graph.scale(-0.5, product);
                add(graph, EnergyTerm::CentrifugalStiffening, expression);
                // -ω·ϑ(Γ_μν) q_ν q̇_μ
                let product = spin(graph, omega, stiffness, q_dot[mu]);
                let product = graph.multiply(q[nu], product);
                let expression = graph.negate(product);
                add(graph, EnergyTerm::AngularAccelerationStiffening, expression);
                // -v·(ω × ½ q_μ q_ν Γ_μν + q_ν q̇_μ Γ_μν)
                let stiffness = inertia.uniform_load_stiffness[mu][nu];
                let half = graph.scale(0.5, coordinates);
                let moment = stiffness.map(|component| graph.multiply(half, component));
                let carried = cross(graph, omega, moment);
                let rate = graph.multiply(q[nu], q_dot[mu]);
                let own = stiffness.map(|component| graph.multiply(rate, component));
                let sum = sum3(graph, carried, own);
                let product = dot(graph, v, sum);
                let expression = graph.negate(product);
                add(graph, EnergyTerm::LinearAccelerationStiffening, expression);
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
