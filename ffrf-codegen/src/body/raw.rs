//! The raw invariants of a body as full matrices: what the energy is written from.

use crate::expression::{Expression, Graph, Vector};
use crate::invariants::{Invariant, Structure};

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
    /// Geometric stiffness Γ_μν^j of the body forces ρ e_j. Shape: M x M x 3, Γ_νμ = Γ_μν.
    pub uniform_load_stiffness: Vec<Vec<Vector>>,
    /// Geometric stiffness Γ_μν^{ij} of the body forces ρ xⁱ e_j. Shape: M x M x 3 x 3, Γ_νμ = Γ_μν.
    pub linear_load_stiffness: Vec<Vec<Matrix>>,
}

impl RawInertia {
    /// Number of modes M.
    pub fn mode_count(&self) -> usize {
        self.modal_first_moment.len()
    }

    /// Every invariant a symbol of its own; Θ_ff = [tr T_μν].
    pub fn dense(graph: &mut Graph, mode_count: usize) -> Self {
        let modes = 0..mode_count;
        let second_moment = matrix(|i, j| graph.symbol(Invariant::SecondMoment.at([i.min(j), i.max(j)])));
        let position_mode_moment: Vec<Matrix> = modes
            .clone()
            .map(|mu| matrix(|i, j| graph.symbol(Invariant::PositionModeMoment.at([mu, i, j]))))
            .collect();
        let mode_mode_moment: Vec<Vec<Matrix>> = modes
            .clone()
            .map(|mu| modes.clone().map(|nu| matrix(|i, j| mode_mode_symbol(graph, mu, nu, i, j))).collect())
            .collect();
        let modal_mass =
            mode_mode_moment.iter().map(|row| row.iter().map(|t| trace(graph, t)).collect()).collect();
        Self {
            mass: graph.symbol(Invariant::Mass.at([])),
            first_moment: [0, 1, 2].map(|i| graph.symbol(Invariant::FirstMoment.at([i]))),
            modal_first_moment: modes
                .map(|mu| [0, 1, 2].map(|i| graph.symbol(Invariant::ModalFirstMoment.at([mu, i]))))
                .collect(),
            second_moment,
            position_mode_moment,
            mode_mode_moment,
            modal_mass,
            uniform_load_stiffness: uniform_load_stiffness(graph, mode_count, Structure::Dense),
            linear_load_stiffness: linear_load_stiffness(graph, mode_count, Structure::Dense),
        }
    }
}

/// Γ_μν^j, the same for Γ_νμ^j.
pub(super) fn uniform_load_stiffness(
    graph: &mut Graph,
    mode_count: usize,
    structure: Structure,
) -> Vec<Vec<Vector>> {
    pairs(mode_count, |mu, nu| {
        [0, 1, 2].map(|j| match structure {
            Structure::Zero => graph.zero(),
            _ => graph.symbol(Invariant::UniformLoadStiffness.at([mu, nu, j])),
        })
    })
}

/// Γ_μν^{ij}, the same for Γ_νμ^{ij}.
pub(super) fn linear_load_stiffness(
    graph: &mut Graph,
    mode_count: usize,
    structure: Structure,
) -> Vec<Vec<Matrix>> {
    pairs(mode_count, |mu, nu| {
        matrix(|i, j| match structure {
            Structure::Zero => graph.zero(),
            _ => graph.symbol(Invariant::LinearLoadStiffness.at([mu, nu, i, j])),
        })
    })
}

/// A symmetric M x M list, from `entry(mu, nu)` with mu <= nu.
pub(super) fn pairs<T>(mode_count: usize, mut entry: impl FnMut(usize, usize) -> T) -> Vec<Vec<T>> {
    let modes = || 0..mode_count;
    modes().map(|mu| modes().map(|nu| entry(mu.min(nu), mu.max(nu))).collect()).collect()
}

/// The symbol of T_μν^{ij}, the same for T_νμ^{ji}.
fn mode_mode_symbol(graph: &mut Graph, mu: usize, nu: usize, i: usize, j: usize) -> Expression {
    let swap = mu > nu || (mu == nu && i > j);
    graph.symbol(if swap {
        Invariant::ModeModeMoment.at([nu, mu, j, i])
    } else {
        Invariant::ModeModeMoment.at([mu, nu, i, j])
    })
}

/// The matrix with the given entries.
pub(crate) fn matrix(mut entry: impl FnMut(usize, usize) -> Expression) -> Matrix {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)))
}

/// tr T
pub(crate) fn trace(graph: &mut Graph, moment: &Matrix) -> Expression {
    graph.sum([moment[0][0], moment[1][1], moment[2][2]])
}
