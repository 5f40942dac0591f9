//! Inverses of symmetric positive definite 3 x 3 matrices.

use super::Draft;
use super::modal_mass::minus_products;
use crate::expression::{Expression, Graph, Symmetric3, Vector, dot};

/// The inverse by cofactors: one division, short dependency chains.
///
/// How accurate it is: the matrix S is what elimination of translation and modes leaves of Θ_rr. Each product in a
/// cofactor and in the determinant takes one entry of each row and column involved, so scaling S to D S D with a
/// diagonal D scales both terms of every difference alike: rounding is that of the matrix scaled to a unit diagonal, and
/// the accelerations are as accurate as the condition number κ of that matrix allows (forward error of the order of
/// κ ε). Slenderness by itself does not count: in a frame along the body κ is about 10 whatever the thickness.
///
/// In a frame askew to a body of length to thickness 1e4, κ is 1e9 and accelerations are good to 6e-8, from cofactors
/// as from a factorisation. But the inverse is not backward stable: where the moment about the long axis is small, the
/// error is in all directions and the equations are left with a residual of 1e-8 of their terms, while a factorisation
/// leaves 1e-16 and keeps 1e-12 across the long axis. The cure is a frame along the body.
/// Figures: `tests/slender_bodies` of the facade.
pub(super) fn inverse_by_cofactors(graph: &mut Draft, matrix: &Symmetric3) -> Symmetric3 {
    let one = graph.one();
    if matrix.off_diagonal.iter().all(|&entry| graph.is_zero(entry)) {
        return Symmetric3 {
            diagonal: matrix.diagonal.map(|entry| graph.divide(one, entry)),
            off_diagonal: matrix.off_diagonal,
        };
    }
    let minor = |graph: &mut Graph, [a, b, c, d]: [Expression; 4]| {
        let left = graph.multiply(a, b);
        let right = graph.multiply(c, d);
        graph.subtract(left, right)
    };
    let ([xx, yy, zz], [yz, xz, xy]) = (matrix.diagonal, matrix.off_diagonal);
    let diagonal =
        [minor(graph, [yy, zz, yz, yz]), minor(graph, [xx, zz, xz, xz]), minor(graph, [xx, yy, xy, xy])];
    let off_diagonal =
        [minor(graph, [xy, xz, xx, yz]), minor(graph, [xy, yz, yy, xz]), minor(graph, [xz, yz, zz, xy])];
    let determinant = dot(graph, [xx, xy, xz], [diagonal[0], off_diagonal[2], off_diagonal[1]]);
    let inverse = graph.divide(one, determinant);
    graph.label(inverse, "inverse_determinant");
    Symmetric3 {
        diagonal: diagonal.map(|entry| graph.multiply(entry, inverse)),
        off_diagonal: off_diagonal.map(|entry| graph.multiply(entry, inverse)),
    }
}

/// The inverse by L D Lᵀ: three divisions, backward stable for every positive definite matrix.
///
/// Used for what is constant, hence free in generated code. Returns the pivots D as well.
pub(super) fn inverse_by_factors(graph: &mut Graph, matrix: &Symmetric3) -> (Symmetric3, Vector) {
    let one = graph.one();
    let zero = graph.zero();
    let mut lower = [[zero; 3]; 3];
    let mut pivots = [zero; 3];
    for i in 0..3 {
        for j in 0..i {
            let mut sum = matrix.at(i, j);
            for k in 0..j {
                let scaled = graph.multiply(lower[i][k], pivots[k]);
                sum = minus_products(graph, sum, [(scaled, lower[j][k])]);
            }
            lower[i][j] = graph.divide(sum, pivots[j]);
        }
        let mut pivot = matrix.at(i, i);
        for k in 0..i {
            let scaled = graph.multiply(lower[i][k], pivots[k]);
            pivot = minus_products(graph, pivot, [(scaled, lower[i][k])]);
        }
        pivots[i] = pivot;
    }
    // Columns of the inverse: L z = e, D y = z, Lᵀ x = y.
    let columns = [0, 1, 2].map(|column| {
        let mut x = [zero; 3];
        x[column] = one;
        for i in 0..3 {
            x[i] = minus_products(graph, x[i], (0..i).map(|k| (lower[i][k], x[k])));
        }
        for i in 0..3 {
            x[i] = graph.divide(x[i], pivots[i]);
        }
        for i in (0..3).rev() {
            x[i] = minus_products(graph, x[i], (i + 1..3).map(|k| (lower[k][i], x[k])));
        }
        x
    });
    let inverse = Symmetric3 {
        diagonal: [columns[0][0], columns[1][1], columns[2][2]],
        off_diagonal: [columns[1][2], columns[0][2], columns[0][1]],
    };
    (inverse, pivots)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn constants(graph: &mut Graph) -> Symmetric3 {
        Symmetric3 {
            diagonal: [4.0, 5.0, 6.0].map(|value| graph.constant(value)),
            off_diagonal: [1.0, -0.5, 2.0].map(|value| graph.constant(value)),
        }
    }

    #[test]
    fn both_inverses_times_the_matrix_are_the_identity() {
        let mut graph = Draft::default();
        let matrix = constants(&mut graph);
        let (by_factors, pivots) = inverse_by_factors(&mut graph, &matrix);
        let by_cofactors = inverse_by_cofactors(&mut graph, &matrix);
        assert!(pivots.iter().all(|&pivot| graph.constant_value(pivot).unwrap() > 0.0));
        for inverse in [by_factors, by_cofactors] {
            for i in 0..3 {
                for j in 0..3 {
                    let row = [0, 1, 2].map(|k| inverse.at(i, k));
                    let column = [0, 1, 2].map(|k| matrix.at(k, j));
                    let product = dot(&mut graph, row, column);
                    let expected = if i == j { 1.0 } else { 0.0 };
                    let found = graph.constant_value(product).unwrap();
                    // Three products of numbers of order one.
                    assert!((found - expected).abs() < 1e-15, "({i}, {j}): {found}");
                }
            }
        }
    }

    #[test]
    fn a_diagonal_matrix_is_inverted_without_cofactors() {
        let mut graph = Draft::default();
        let mut matrix = constants(&mut graph);
        matrix.off_diagonal = [graph.zero(); 3];
        let inverse = inverse_by_cofactors(&mut graph, &matrix);
        assert_eq!(
            inverse.diagonal.map(|entry| graph.constant_value(entry)),
            [Some(1.0 / 4.0), Some(1.0 / 5.0), Some(1.0 / 6.0)]
        );
    }
}
