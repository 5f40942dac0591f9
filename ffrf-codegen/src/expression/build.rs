//! Building expressions, folding what can be seen locally.
//!
//! Changes of sign travel outwards: (-a) b becomes -(a b), a + (-b) becomes a - b. Operands of commutative
//! operations are put in index order. So more subexpressions meet as one node.

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
        match self.node(a) {
            Node::Constant(constant) => self.constant(-constant.value()),
            Node::Negate(inner) => inner,
            Node::Subtract(left, right) => self.subtract(right, left),
            _ => self.insert(Node::Negate(a)),
        }
    }

    /// a + b
    pub fn add(&mut self, a: Expression, b: Expression) -> Expression {
        match (self.constant_value(a), self.constant_value(b)) {
            (Some(left), Some(right)) => return self.fold_sum(left, right),
            (Some(0.0), _) => return b,
            (_, Some(0.0)) => return a,
            _ => {}
        }
        match (self.node(a), self.node(b)) {
            (Node::Negate(left), Node::Negate(right)) => {
                let sum = self.add(left, right);
                self.negate(sum)
            }
            (Node::Negate(left), _) => self.subtract(b, left),
            (_, Node::Negate(right)) => self.subtract(a, right),
            _ => self.insert(Node::Add(a.min(b), a.max(b))),
        }
    }

    /// a - b
    pub fn subtract(&mut self, a: Expression, b: Expression) -> Expression {
        if a == b {
            return self.zero();
        }
        match (self.constant_value(a), self.constant_value(b)) {
            (Some(left), Some(right)) => return self.fold_sum(left, -right),
            (Some(0.0), _) => return self.negate(b),
            (_, Some(0.0)) => return a,
            _ => {}
        }
        match (self.node(a), self.node(b)) {
            (Node::Negate(left), Node::Negate(right)) => self.subtract(right, left),
            (_, Node::Negate(right)) => self.add(a, right),
            (Node::Negate(left), _) => {
                let sum = self.add(left, b);
                self.negate(sum)
            }
            _ => self.insert(Node::Subtract(a, b)),
        }
    }

    /// a b
    pub fn multiply(&mut self, a: Expression, b: Expression) -> Expression {
        match (self.constant_value(a), self.constant_value(b)) {
            (Some(left), Some(right)) => return self.fold_product(left, right),
            (Some(0.0), _) | (_, Some(0.0)) => return self.zero(),
            (Some(1.0), _) => return b,
            (_, Some(1.0)) => return a,
            (Some(-1.0), _) => return self.negate(b),
            (_, Some(-1.0)) => return self.negate(a),
            _ => {}
        }
        match (self.node(a), self.node(b)) {
            (Node::Negate(left), Node::Negate(right)) => self.multiply(left, right),
            (Node::Negate(inner), Node::Constant(constant))
            | (Node::Constant(constant), Node::Negate(inner)) => {
                let factor = self.constant(-constant.value());
                self.multiply(inner, factor)
            }
            (Node::Negate(left), _) => {
                let product = self.multiply(left, b);
                self.negate(product)
            }
            (_, Node::Negate(right)) => {
                let product = self.multiply(a, right);
                self.negate(product)
            }
            _ => self.insert(Node::Multiply(a.min(b), a.max(b))),
        }
    }

    /// a b + c as one operation, rounded once where the target can.
    pub fn multiply_add(&mut self, a: Expression, b: Expression, c: Expression) -> Expression {
        let foldable =
            |graph: &Self, x| graph.constant_value(x).is_some_and(|value| value == 0.0 || value.abs() == 1.0);
        let constants = self.constant_value(a).is_some() && self.constant_value(b).is_some();
        if constants || self.is_zero(c) || foldable(self, a) || foldable(self, b) {
            let product = self.multiply(a, b);
            return self.add(product, c);
        }
        self.insert(Node::MultiplyAdd(a, b, c))
    }

    /// a / b
    pub fn divide(&mut self, a: Expression, b: Expression) -> Expression {
        match (self.constant_value(a), self.constant_value(b)) {
            (Some(left), Some(right)) if right != 0.0 => {
                let quotient = left / right;
                if quotient.mul_add(-right, left) != 0.0 {
                    self.count_rounded_fold();
                }
                return self.constant(quotient);
            }
            (Some(0.0), None) => return self.zero(),
            (_, Some(1.0)) => return a,
            (_, Some(-1.0)) => return self.negate(a),
            _ => {}
        }
        match (self.node(a), self.node(b)) {
            (Node::Negate(left), Node::Negate(right)) => self.divide(left, right),
            (Node::Negate(left), _) => {
                let quotient = self.divide(left, b);
                self.negate(quotient)
            }
            (_, Node::Negate(right)) => {
                let quotient = self.divide(a, right);
                self.negate(quotient)
            }
            _ => self.insert(Node::Divide(a, b)),
        }
    }

    /// √a
    pub fn square_root(&mut self, a: Expression) -> Expression {
        match self.constant_value(a) {
            Some(value) if value >= 0.0 => {
                let root = value.sqrt();
                if root.mul_add(root, -value) != 0.0 {
                    self.count_rounded_fold();
                }
                self.constant(root)
            }
            _ => self.insert(Node::SquareRoot(a)),
        }
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

    fn fold_sum(&mut self, left: f64, right: f64) -> Expression {
        let sum = left + right;
        let shadow = sum - left;
        if (left - (sum - shadow)) + (right - shadow) != 0.0 {
            self.count_rounded_fold();
        }
        self.constant(sum)
    }

    fn fold_product(&mut self, left: f64, right: f64) -> Expression {
        let product = left * right;
        if left.mul_add(right, -product) != 0.0 {
            self.count_rounded_fold();
        }
        self.constant(product)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn two_symbols() -> (Graph, Expression, Expression) {
        let mut graph = Graph::new();
        let x = graph.symbol(Symbol::Coordinate(0));
        let y = graph.symbol(Symbol::Coordinate(1));
        (graph, x, y)
    }

    #[test]
    fn zeros_and_ones_cost_nothing() {
        let (mut graph, x, _) = two_symbols();
        let zero = graph.zero();
        let one = graph.one();
        assert_eq!(graph.add(x, zero), x);
        assert_eq!(graph.add(zero, x), x);
        assert_eq!(graph.subtract(x, zero), x);
        assert_eq!(graph.multiply(x, zero), zero);
        assert_eq!(graph.multiply(one, x), x);
        assert_eq!(graph.divide(x, one), x);
        assert_eq!(graph.divide(zero, x), zero);
        assert_eq!(graph.subtract(x, x), zero);
        assert_eq!(graph.multiply_add(zero, x, one), one);
        assert_eq!(graph.len(), 4);
    }

    #[test]
    fn signs_travel_outwards() {
        let (mut graph, x, y) = two_symbols();
        let minus_x = graph.negate(x);
        let minus_y = graph.negate(y);
        let product = graph.multiply(x, y);
        assert_eq!(graph.negate(minus_x), x);
        assert_eq!(graph.multiply(minus_x, minus_y), product);
        let negative = graph.multiply(minus_x, y);
        assert_eq!(graph.node(negative), Node::Negate(product));
        let difference = graph.add(x, minus_y);
        assert_eq!(graph.node(difference), Node::Subtract(x, y));
        let reverse = graph.negate(difference);
        assert_eq!(graph.node(reverse), Node::Subtract(y, x));
        let scaled = graph.scale(2.0, x);
        let scaled_negative = graph.scale(-2.0, minus_x);
        assert_eq!(scaled, scaled_negative);
    }

    #[test]
    fn order_of_commutative_operands_does_not_matter() {
        let (mut graph, x, y) = two_symbols();
        assert_eq!(graph.add(x, y), graph.add(y, x));
        assert_eq!(graph.multiply(x, y), graph.multiply(y, x));
    }

    #[test]
    fn constants_fold_and_rounding_is_counted() {
        let mut graph = Graph::new();
        let half = graph.constant(0.5);
        let three = graph.constant(3.0);
        let exact = graph.multiply(half, three);
        assert_eq!(graph.constant_value(exact), Some(1.5));
        assert_eq!(graph.rounded_folds(), 0);
        let tenth = graph.constant(0.1);
        let rounded = graph.multiply(tenth, three);
        assert_eq!(graph.constant_value(rounded), Some(0.1 * 3.0));
        assert_eq!(graph.rounded_folds(), 1);
        let four = graph.constant(4.0);
        let root = graph.square_root(four);
        assert_eq!(graph.constant_value(root), Some(2.0));
        assert_eq!(graph.rounded_folds(), 1);
    }
}
