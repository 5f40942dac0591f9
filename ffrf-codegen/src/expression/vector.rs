//! Three-vectors and symmetric 3 x 3 matrices of expressions.

use super::{Expression, Graph};

/// Components x, y, z.
pub type Vector = [Expression; 3];

/// A symmetric 3 x 3 matrix of expressions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Symmetric3 {
    /// xx, yy, zz
    pub diagonal: [Expression; 3],
    /// yz, xz, xy: the entry k is in the row and column other than k.
    pub off_diagonal: [Expression; 3],
}

impl Symmetric3 {
    /// The entry in row `i` and column `j`.
    pub fn at(&self, i: usize, j: usize) -> Expression {
        if i == j { self.diagonal[i] } else { self.off_diagonal[3 - i - j] }
    }
}

/// a · b
pub fn dot(graph: &mut Graph, a: Vector, b: Vector) -> Expression {
    let zero = graph.zero();
    graph.sum_of_products(zero, (0..3).map(|i| (a[i], b[i])))
}

/// a × b
pub fn cross(graph: &mut Graph, a: Vector, b: Vector) -> Vector {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| {
        let left = graph.multiply(a[i], b[j]);
        let right = graph.multiply(a[j], b[i]);
        graph.subtract(left, right)
    })
}

/// a + b
pub fn sum3(graph: &mut Graph, a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| graph.add(a[i], b[i]))
}

/// a - b
pub fn subtract3(graph: &mut Graph, a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| graph.subtract(a[i], b[i]))
}

/// -a
pub fn negate3(graph: &mut Graph, a: Vector) -> Vector {
    a.map(|component| graph.negate(component))
}

/// S a
pub fn symmetric_times(graph: &mut Graph, matrix: &Symmetric3, a: Vector) -> Vector {
    [0, 1, 2].map(|i| dot(graph, [matrix.at(i, 0), matrix.at(i, 1), matrix.at(i, 2)], a))
}

#[cfg(test)]
mod tests {
    use super::super::{Input, Symbol, evaluate};
    use super::*;

    #[test]
    fn cross_product_and_symmetric_product_have_their_usual_values() {
        let mut graph = Graph::new();
        let a = [0, 1, 2].map(|i| graph.symbol(Input::VELOCITY.symbol(i)));
        let b = [0, 1, 2].map(|i| graph.symbol(Input::ANGULAR_VELOCITY.symbol(i)));
        let c = cross(&mut graph, a, b);
        let matrix = Symmetric3 { diagonal: a, off_diagonal: b };
        let product = symmetric_times(&mut graph, &matrix, a);
        let value = |symbol| match symbol {
            Symbol::Input(Input::VELOCITY, i) => [1.0, 2.0, 3.0][i],
            Symbol::Input(Input::ANGULAR_VELOCITY, i) => [5.0, 7.0, 11.0][i],
            _ => f64::NAN,
        };
        assert_eq!(evaluate(&graph, &c, value), [22.0 - 21.0, 15.0 - 11.0, 7.0 - 10.0]);
        // rows: [1 11 7], [11 2 5], [7 5 3]
        assert_eq!(evaluate(&graph, &product, value), [44.0, 30.0, 26.0]);
    }
}
