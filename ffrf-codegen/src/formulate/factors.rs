//! Triangular factors of symmetric positive definite 3 x 3 matrices.

use super::modal_mass::minus_products;
use crate::expression::{Expression, Graph, Symmetric3, Vector};

/// S = L D Lᵀ with ones on the diagonal of L.
///
/// A solution by these factors is that of a matrix within rounding of S, entry by entry, whatever the condition number
/// (N. J. Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., theorem 10.3). A product with S⁻¹ is not: its
/// error grows with the square of the condition number where the solution is no larger than usual.
/// Figures: `tests/accuracy_of_accelerations` of the facade.
#[derive(Debug, Clone, Copy)]
pub(super) struct Factors {
    /// L_yx, L_zx, L_zy.
    pub(super) lower: Vector,
    /// 1 / D.
    pub(super) inverse_pivots: Vector,
}

impl Factors {
    /// The factors of a matrix that is constant in the state, and its pivots D: column by column.
    pub(super) fn new(graph: &mut Graph, matrix: &Symmetric3) -> (Self, Vector) {
        let one = graph.one();
        let ([xx, yy, zz], [yz, xz, xy]) = (matrix.diagonal, matrix.off_diagonal);
        let first = graph.divide(one, xx);
        let [lower_y, lower_z] = [xy, xz].map(|entry| graph.multiply(entry, first));
        let yy = minus_products(graph, yy, [(lower_y, xy)]);
        let yz = minus_products(graph, yz, [(lower_z, xy)]);
        let second = graph.divide(one, yy);
        let lower_zy = graph.multiply(yz, second);
        let zz = minus_products(graph, zz, [(lower_z, xz), (lower_zy, yz)]);
        let third = graph.divide(one, zz);
        let factors = Self { lower: [lower_y, lower_z, lower_zy], inverse_pivots: [first, second, third] };
        (factors, [xx, yy, zz])
    }

    /// L⁻¹ v
    pub(super) fn forward(&self, graph: &mut Graph, [x, y, z]: Vector) -> Vector {
        let [lower_y, lower_z, lower_zy] = self.lower;
        let y = minus_products(graph, y, [(lower_y, x)]);
        let z = minus_products(graph, z, [(lower_z, x), (lower_zy, y)]);
        [x, y, z]
    }

    /// D⁻¹ v
    pub(super) fn weigh(&self, graph: &mut Graph, v: Vector) -> Vector {
        [0, 1, 2].map(|i| graph.multiply(v[i], self.inverse_pivots[i]))
    }

    /// L⁻ᵀ v
    pub(super) fn backward(&self, graph: &mut Graph, [x, y, z]: Vector) -> Vector {
        let [lower_y, lower_z, lower_zy] = self.lower;
        let y = minus_products(graph, y, [(lower_zy, z)]);
        let x = minus_products(graph, x, [(lower_z, z), (lower_y, y)]);
        [x, y, z]
    }
}

/// S⁻¹ v for a matrix that follows from the state: the elimination of [`Factors`] with rows multiplied by the pivots instead
/// of divided, so that no division waits for another, and the right-hand side eliminated along with the matrix: that is
/// fewer operations than a solution by L and D, which nobody needs here.
///
/// `scale` is about one over the size of the entries, to any accuracy: without it the last pivot is of their fourth power,
/// which f32 does not hold for a body of a gram and a millimetre.
pub(super) fn solve_with_divisions_deferred(
    graph: &mut Graph,
    matrix: &Symmetric3,
    scale: Expression,
    [x, y, z]: Vector,
) -> Vector {
    let one = graph.one();
    let ([xx, yy, zz], [yz, xz, xy]) = (matrix.diagonal, matrix.off_diagonal);
    // Rows y and z times the scaled pivot xx, unless row x has nothing to do with them.
    let is_coupled = [xy, xz].iter().any(|entry| !graph.is_zero(*entry));
    let pivot = if is_coupled { graph.multiply(xx, scale) } else { one };
    let [scaled_y, scaled_z] = [xy, xz].map(|entry| graph.multiply(entry, scale));
    let mut rest = |entry: Expression, left: Expression, right: Expression| {
        let product = graph.multiply(pivot, entry);
        minus_products(graph, product, [(left, right)])
    };
    let (yy, yz, zz) = (rest(yy, scaled_y, xy), rest(yz, scaled_y, xz), rest(zz, scaled_z, xz));
    let (y, z) = (rest(y, scaled_y, x), rest(z, scaled_z, x));
    let [first, second] = [xx, yy].map(|pivot| graph.divide(one, pivot));
    // The last row times the pivot yy, likewise.
    let (pivot, zz) = if graph.is_zero(yz) { (one, zz) } else { (yy, graph.multiply(yy, zz)) };
    let zz = minus_products(graph, zz, [(yz, yz)]);
    let third = graph.divide(one, zz);
    let z = graph.multiply(pivot, z);
    let z = minus_products(graph, z, [(yz, y)]);
    let z = graph.multiply(z, third);
    // Rows are divided before the unknowns to the right are known: one operation a row is left to wait for.
    let [y, yz] = [y, yz].map(|entry| graph.multiply(entry, second));
    let [x, xz, xy] = [x, xz, xy].map(|entry| graph.multiply(entry, first));
    let y = minus_products(graph, y, [(yz, z)]);
    let x = minus_products(graph, x, [(xz, z), (xy, y)]);
    [x, y, z]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::{Input, symmetric_times};

    const OFF_DIAGONALS: [[f64; 3]; 5] =
        [[1.0, -0.5, 2.0], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 2.0], [0.0, -0.5, 0.0]];

    fn constants(graph: &mut Graph, off_diagonal: [f64; 3]) -> Symmetric3 {
        Symmetric3 {
            diagonal: [4.0, 5.0, 6.0].map(|value| graph.constant(value)),
            off_diagonal: off_diagonal.map(|value| graph.constant(value)),
        }
    }

    #[test]
    fn the_matrix_times_a_solution_is_the_right_hand_side() {
        for off_diagonal in OFF_DIAGONALS {
            let mut graph = Graph::new();
            let matrix = constants(&mut graph, off_diagonal);
            let scale = graph.constant(0.1);
            let (factors, pivots) = Factors::new(&mut graph, &matrix);
            assert!(pivots.iter().all(|&pivot| graph.constant_value(pivot).unwrap() > 0.0));
            let expected = [1.0, -2.0, 3.0];
            let right = expected.map(|value| graph.constant(value));
            let solved = factors.forward(&mut graph, right);
            let solved = factors.weigh(&mut graph, solved);
            let solutions = [
                factors.backward(&mut graph, solved),
                solve_with_divisions_deferred(&mut graph, &matrix, scale, right),
            ];
            for solution in solutions {
                let found = symmetric_times(&mut graph, &matrix, solution);
                for (found, expected) in found.into_iter().zip(expected) {
                    let found = graph.constant_value(found).unwrap();
                    // Some products of numbers of order one.
                    assert!((found - expected).abs() < 4e-15, "{off_diagonal:?}: {found}");
                }
            }
        }
    }

    #[test]
    fn a_diagonal_matrix_costs_three_divisions_and_no_more() {
        let mut graph = Graph::new();
        let [diagonal, right] = [Input::ANGULAR_VELOCITY, Input::VELOCITY]
            .map(|input| [0, 1, 2].map(|axis| graph.symbol(input.symbol(axis))));
        let zero = graph.zero();
        let matrix = Symmetric3 { diagonal, off_diagonal: [zero; 3] };
        let scale = graph.constant(0.1);
        let before = graph.len();
        solve_with_divisions_deferred(&mut graph, &matrix, scale, right);
        let operations = graph.nodes().skip(before).filter(|(_, node)| node.is_operation()).count();
        assert_eq!(operations, 3 + 3, "a division and a product for each axis");
    }
}
