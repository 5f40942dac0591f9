//! Building expressions: one method per operation, simplified by the [rules](super::rules) on insertion.

use super::{Constant, Expression, Graph, Node, Symbol};

impl Graph {
    /// A number.
    pub fn constant(&mut self, value: f64) -> Expression {
        self.insert(Node::Constant(Constant::new(value)))
    }

    /// The number 0.
    pub fn zero(&mut self) -> Expression {
        self.insert(Node::Constant(Constant::ZERO))
    }

    /// The number 1.
    pub fn one(&mut self) -> Expression {
        self.insert(Node::Constant(Constant::ONE))
    }

    /// An input.
    pub fn symbol(&mut self, symbol: Symbol) -> Expression {
        self.insert(Node::Symbol(symbol))
    }

    /// -a
    pub fn negate(&mut self, a: Expression) -> Expression {
        self.simplified(Node::Negate(a))
    }

    /// a + b
    pub fn add(&mut self, a: Expression, b: Expression) -> Expression {
        self.simplified(Node::Add(a, b))
    }

    /// a - b
    pub fn subtract(&mut self, a: Expression, b: Expression) -> Expression {
        self.simplified(Node::Subtract(a, b))
    }

    /// a b
    pub fn multiply(&mut self, a: Expression, b: Expression) -> Expression {
        self.simplified(Node::Multiply(a, b))
    }

    /// a b + c as one operation, rounded once where the target can.
    pub fn multiply_add(&mut self, a: Expression, b: Expression, c: Expression) -> Expression {
        self.simplified(Node::MultiplyAdd(a, b, c))
    }

    /// a / b
    pub fn divide(&mut self, a: Expression, b: Expression) -> Expression {
        self.simplified(Node::Divide(a, b))
    }

    /// √a
    pub fn square_root(&mut self, a: Expression) -> Expression {
        self.simplified(Node::SquareRoot(a))
    }

    /// factor · a for a number.
    pub fn scale(&mut self, factor: f64, a: Expression) -> Expression {
        let factor = self.constant(factor);
        self.multiply(factor, a)
    }

    /// The sum of all, from the first to the last.
    pub fn sum(&mut self, terms: impl IntoIterator<Item = Expression>) -> Expression {
        let mut total = self.zero();
        for term in terms {
            total = self.add(total, term);
        }
        total
    }

    /// start + Σ a_k b_k, from the first to the last.
    pub fn sum_of_products(
        &mut self,
        start: Expression,
        factors: impl IntoIterator<Item = (Expression, Expression)>,
    ) -> Expression {
        let mut total = start;
        for (a, b) in factors {
            let product = self.multiply(a, b);
            total = self.add(total, product);
        }
        total
    }
}

#[cfg(test)]
mod tests {
    use super::super::Input;
    use super::*;

    #[test]
    fn order_of_commutative_operands_does_not_matter() {
        let mut graph = Graph::new();
        let x = graph.symbol(Input::COORDINATES.symbol(0));
        let y = graph.symbol(Input::COORDINATES.symbol(1));
        assert_eq!(graph.add(x, y), graph.add(y, x));
        assert_eq!(graph.multiply(x, y), graph.multiply(y, x));
    }
}
