//! Forward dynamics: modal accelerations eliminated first, then a 6 x 6 system in 3 x 3 blocks.

use super::factors::{Factors, solve_with_divisions_deferred};
use super::modal_mass::{ModalMass, Prepared, minus_products};
use super::pivot::{BadPivot, bad_pivot};
use super::structured::label3;
use super::{DeformedBody, Draft, State, internal_force};
use crate::CodegenError;
use crate::body::BodyExpressions;
use crate::expression::{Expression, Graph, Symmetric3, Vector, negate3};

/// Accelerations [α; ω̇; q̈] under `state.force`, with the quadratic velocity vector at hand.
///
/// M = L D Lᵀ in the order modes, translation, rotation, with what is constant of L and D folded when the code is
/// generated: Θ_ff, and what the modes leave of the mass, m I - m B Θ_ff⁻¹ (m B)ᵀ. The mass matrix itself is never
/// formed. Nothing is multiplied by an inverse, so that accelerations are as accurate as those of a Cholesky
/// factorisation of the mass matrix, see `factors.rs`.
///
/// Errors: [`CodegenError::RepeatedModes`] or [`CodegenError::DependentModes`] if Θ_ff or the reduced mass is a constant
/// that is not positive definite.
pub fn forward_dynamics(
    graph: &mut Draft,
    body: &BodyExpressions,
    state: &State,
    deformed: &DeformedBody,
    quadratic: &[Expression],
) -> Result<Vec<Expression>, CodegenError> {
    graph.section("Modal forces f - Q_f - K q - D q̇");
    let internal = internal_force(graph, body, state);
    let mut residual = Vec::with_capacity(quadratic.len());
    for (&applied, &inertial) in state.force.iter().zip(quadratic) {
        residual.push(graph.subtract(applied, inertial));
    }
    let mut modal_residual = residual.split_off(6);
    for (mu, force) in modal_residual.iter_mut().enumerate() {
        *force = graph.subtract(*force, internal[mu]);
        graph.label(*force, format!("modal_residual{mu}"));
    }

    graph.section("Elimination of the modal accelerations");
    let modal_mass = ModalMass::new(graph, body)?;
    let rows = |row: &dyn Fn(usize) -> Vec<Expression>, graph: &mut Graph| {
        [0, 1, 2].map(|i| modal_mass.prepare(graph, &row(i)))
    };
    let translation = rows(&|i| deformed.modal_first_moment.iter().map(|b| b[i]).collect(), graph);
    let rotation = rows(&|i| deformed.moments.iter().map(|moment| moment.odd[i]).collect(), graph);
    let modal = modal_mass.prepare(graph, &modal_residual);

    let zero = graph.zero();
    let translation_mass = reduced(graph, &translation, |i, j| if i == j { body.mass } else { zero });
    let rotation_mass = reduced(graph, &rotation, |i, j| deformed.inertia.at(i, j));
    let [x, y, z] = deformed.first_moment;
    let [minus_x, minus_y, minus_z] = negate3(graph, deformed.first_moment);
    let skew = [[zero, z, minus_y], [minus_z, zero, x], [y, minus_x, zero]];
    let coupling = [0, 1, 2]
        .map(|i| [0, 1, 2].map(|j| translation[i].subtract_product(graph, skew[i][j], &rotation[j])));
    let force = [0, 1, 2].map(|i| translation[i].subtract_product(graph, residual[i], &modal));
    let moment = [0, 1, 2].map(|i| rotation[i].subtract_product(graph, residual[3 + i], &modal));
    label3(graph, force, "reduced_force");
    label3(graph, moment, "reduced_moment");

    graph.section("Rigid-body accelerations");
    let (mass, pivots) = Factors::new(graph, &translation_mass);
    check_pivots(graph, pivots, body.mass)?;
    let columns = [0, 1, 2].map(|j| {
        let column = [0, 1, 2].map(|i: usize| coupling[i][j]);
        mass.forward(graph, column)
    });
    let shift = columns.map(|column| mass.weigh(graph, column));
    let force = mass.forward(graph, force);
    let drift = mass.weigh(graph, force);
    let schur = |graph: &mut Graph, start: Expression, i: usize, other: Vector| {
        let terms = (0..3).map(|k| (columns[i][k], other[k]));
        minus_products(graph, start, terms)
    };
    let remaining = Symmetric3 {
        diagonal: [0, 1, 2].map(|i| schur(graph, rotation_mass.at(i, i), i, shift[i])),
        off_diagonal: [(1, 2), (0, 2), (0, 1)]
            .map(|(i, j)| schur(graph, rotation_mass.at(i, j), i, shift[j])),
    };
    let remaining_moment = [0, 1, 2].map(|i| schur(graph, moment[i], i, drift));
    let scale = scale(graph, &body.inertia);
    let angular = solve_with_divisions_deferred(graph, &remaining, scale, remaining_moment);
    label3(graph, angular, "angular_acceleration");
    // Unknowns enter in the order in which they are found, so that little is left to do behind the last one.
    let linear = [0, 1, 2].map(|i| {
        let terms = (0..3).rev().map(|j| (shift[j][i], angular[j]));
        minus_products(graph, drift[i], terms)
    });
    let linear = mass.backward(graph, linear);
    label3(graph, linear, "acceleration");

    graph.section("Modal accelerations");
    let corrections: Vec<(&Prepared, Expression)> =
        translation.iter().zip(linear).chain(rotation.iter().zip(angular)).rev().collect();
    let modal_acceleration = modal_mass.solve(graph, &modal, &corrections);
    Ok(linear.into_iter().chain(angular).chain(modal_acceleration).collect())
}

/// start_ij - x_iᵀ Θ_ff⁻¹ x_j
fn reduced(
    graph: &mut Graph,
    rows: &[Prepared; 3],
    start: impl Fn(usize, usize) -> Expression,
) -> Symmetric3 {
    let mut entry = |i: usize, j: usize| rows[i].subtract_product(graph, start(i, j), &rows[j]);
    Symmetric3 {
        diagonal: [entry(0, 0), entry(1, 1), entry(2, 2)],
        off_diagonal: [entry(1, 2), entry(0, 2), entry(0, 1)],
    }
}

/// One over the size of the moments of inertia, for [`solve_with_divisions_deferred`].
fn scale(graph: &mut Graph, inertia: &Symmetric3) -> Expression {
    let one = graph.one();
    let trace = graph.sum(inertia.diagonal);
    if graph.is_zero(trace) { one } else { graph.divide(one, trace) }
}

/// A constant reduced mass must be positive, by more than round-off of the mass.
pub(super) fn check_pivots(graph: &Graph, pivots: Vector, mass: Expression) -> Result<(), CodegenError> {
    for (pivot, &expression) in pivots.iter().enumerate() {
        if let Some(BadPivot { found, .. }) = bad_pivot(graph, expression, mass) {
            return Err(CodegenError::DependentModes { pivot, found });
        }
    }
    Ok(())
}
