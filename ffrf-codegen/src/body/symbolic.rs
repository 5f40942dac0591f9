//! A body whose invariants are symbols, as far as its layout leaves them open.

use super::BodyExpressions;
use super::raw::{Matrix, RawInertia, linear_load_stiffness, uniform_load_stiffness};
use crate::expression::{Expression, Graph};
use crate::invariants::{Invariant, Structure};
use crate::layout::Layout;

impl BodyExpressions {
    /// A body with symbols for what `layout` leaves open, zeros and ones for what it fixes.
    pub fn symbolic(graph: &mut Graph, mode_count: usize, layout: &Layout) -> Self {
        let raw = raw_inertia(graph, mode_count, layout);
        let stiffness = modal_matrix(graph, mode_count, layout, Invariant::Stiffness);
        let damping = modal_matrix(graph, mode_count, layout, Invariant::Damping);
        Self::from_raw(graph, &raw, layout[Invariant::ModalMass], stiffness, damping)
    }
}

/// The full matrices of a symbolic body: the input of the energy as well as of the structured kernels.
///
/// Θ_ff = [tr T_μν] holds identically: where the layout fixes an entry of Θ_ff, T_μν^{xx} is what the trace
/// leaves. The kernels never use it. Where T_μν is declared zero or antisymmetric, the other entries of Θ_ff are
/// symbols of their own, and T_μν^{xx} follows from them as well.
pub fn raw_inertia(graph: &mut Graph, mode_count: usize, layout: &Layout) -> RawInertia {
    let modes = || 0..mode_count;
    let mut position_mode_moment = Vec::with_capacity(mode_count);
    for mu in modes() {
        position_mode_moment.push(matrix(graph, layout[Invariant::PositionModeMoment], |graph, i, j| {
            graph.symbol(Invariant::PositionModeMoment.at([mu, i, j]))
        }));
    }
    let mut mode_mode_moment = Vec::with_capacity(mode_count);
    let mut modal_mass = Vec::with_capacity(mode_count);
    for mu in modes() {
        let mut moments = Vec::with_capacity(mode_count);
        let mut masses = Vec::with_capacity(mode_count);
        for nu in modes() {
            let mut moment = mode_mode_matrix(graph, mu, nu, layout[Invariant::ModeModeMoment]);
            let mass = match (layout[Invariant::ModalMass], mu == nu) {
                (Structure::Identity, true) => Some(graph.one()),
                (Structure::Identity | Structure::Diagonal, false) => Some(graph.zero()),
                _ if layout.has_own_modal_mass() => {
                    Some(graph.symbol(Invariant::ModalMass.at([mu.min(nu), mu.max(nu)])))
                }
                _ => None,
            };
            masses.push(match mass {
                Some(mass) => {
                    let rest = graph.subtract(mass, moment[1][1]);
                    moment[0][0] = graph.subtract(rest, moment[2][2]);
                    mass
                }
                None => graph.sum([moment[0][0], moment[1][1], moment[2][2]]),
            });
            moments.push(moment);
        }
        mode_mode_moment.push(moments);
        modal_mass.push(masses);
    }
    let zero = graph.zero();
    RawInertia {
        mass: graph.symbol(Invariant::Mass.at([])),
        first_moment: match layout[Invariant::FirstMoment] {
            Structure::Zero => [zero; 3],
            _ => [0, 1, 2].map(|i| graph.symbol(Invariant::FirstMoment.at([i]))),
        },
        modal_first_moment: modes()
            .map(|mu| match layout[Invariant::ModalFirstMoment] {
                Structure::Zero => [zero; 3],
                _ => [0, 1, 2].map(|i| graph.symbol(Invariant::ModalFirstMoment.at([mu, i]))),
            })
            .collect(),
        second_moment: matrix(graph, layout[Invariant::SecondMoment], |graph, i, j| {
            graph.symbol(Invariant::SecondMoment.at([i, j]))
        }),
        position_mode_moment,
        mode_mode_moment,
        modal_mass,
        uniform_load_stiffness: uniform_load_stiffness(
            graph,
            mode_count,
            layout[Invariant::UniformLoadStiffness],
        ),
        linear_load_stiffness: linear_load_stiffness(
            graph,
            mode_count,
            layout[Invariant::LinearLoadStiffness],
        ),
    }
}

/// A symmetric M x M matrix of symbols with the structure that the layout gives `invariant`.
pub fn modal_matrix(
    graph: &mut Graph,
    mode_count: usize,
    layout: &Layout,
    invariant: Invariant,
) -> Vec<Vec<Expression>> {
    let mut rows = Vec::with_capacity(mode_count);
    for mu in 0..mode_count {
        let mut row = Vec::with_capacity(mode_count);
        for nu in 0..mode_count {
            row.push(match (layout[invariant], mu == nu) {
                (Structure::Zero, _) | (Structure::Identity | Structure::Diagonal, false) => graph.zero(),
                (Structure::Identity, true) => graph.one(),
                _ => graph.symbol(invariant.at([mu.min(nu), mu.max(nu)])),
            });
        }
        rows.push(row);
    }
    rows
}

/// T_μν with T_νμ = T_μνᵀ, and T_μμ symmetric.
fn mode_mode_matrix(graph: &mut Graph, mu: usize, nu: usize, structure: Structure) -> Matrix {
    let (first, second) = (mu.min(nu), mu.max(nu));
    let structure = match (structure, mu == nu) {
        (Structure::Dense, true) => Structure::Symmetric,
        // Symmetric and antisymmetric at once.
        (Structure::Antisymmetric, true) => Structure::Zero,
        (structure, _) => structure,
    };
    let upper = matrix(graph, structure, |graph, i, j| {
        graph.symbol(Invariant::ModeModeMoment.at([first, second, i, j]))
    });
    if mu > nu { [0, 1, 2].map(|i| [0, 1, 2].map(|j| upper[j][i])) } else { upper }
}

/// A 3 x 3 matrix of symbols with the given structure.
fn matrix(
    graph: &mut Graph,
    structure: Structure,
    mut symbol: impl FnMut(&mut Graph, usize, usize) -> Expression,
) -> Matrix {
    let mut rows = [[graph.zero(); 3]; 3];
    for i in 0..3 {
        for j in 0..3 {
            rows[i][j] = match structure {
                Structure::Zero => graph.zero(),
                Structure::Identity if i == j => graph.one(),
                Structure::Identity | Structure::Diagonal if i != j => graph.zero(),
                Structure::Symmetric => symbol(graph, i.min(j), i.max(j)),
                Structure::Antisymmetric if i == j => graph.zero(),
                Structure::Antisymmetric if i > j => {
                    let mirrored = symbol(graph, j, i);
                    graph.negate(mirrored)
                }
                _ => symbol(graph, i, j),
            };
        }
    }
    rows
}
