//! Expressions as the scalars of the loops: running a loop writes down what it computes.

use std::cell::RefCell;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use ffrf::generated_support::lanes::{ArrayLanes, HasLanes, Scalar};
use ffrf_codegen::expression::{Expression, Graph};

thread_local! {
    /// Where the loops of this thread write.
    static GRAPH: RefCell<Graph> = RefCell::new(Graph::new());
}

/// Runs `loops` with `graph` as the place to write to.
pub fn record<R>(graph: &mut Graph, loops: impl FnOnce() -> R) -> R {
    GRAPH.with_borrow_mut(|place| std::mem::swap(place, graph));
    let result = loops();
    GRAPH.with_borrow_mut(|place| std::mem::swap(place, graph));
    result
}

/// An expression of the graph that is being written.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Symbolic(pub Expression);

fn write(node: impl FnOnce(&mut Graph) -> Expression) -> Symbolic {
    GRAPH.with_borrow_mut(|graph| Symbolic(node(graph)))
}

impl Add for Symbolic {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        write(|graph| graph.add(self.0, other.0))
    }
}

impl Sub for Symbolic {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        write(|graph| graph.subtract(self.0, other.0))
    }
}

impl Mul for Symbolic {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        write(|graph| graph.multiply(self.0, other.0))
    }
}

impl Div for Symbolic {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        write(|graph| graph.divide(self.0, other.0))
    }
}

impl Neg for Symbolic {
    type Output = Self;
    fn neg(self) -> Self {
        write(|graph| graph.negate(self.0))
    }
}

impl AddAssign for Symbolic {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Symbolic {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl HasLanes<4> for Symbolic {
    type Lanes = ArrayLanes<Self, 4>;
}

impl HasLanes<8> for Symbolic {
    type Lanes = ArrayLanes<Self, 8>;
}

impl Scalar for Symbolic {
    type Constant = Self;

    fn constant(constant: Self) -> Self {
        constant
    }

    fn zero() -> Self {
        write(|graph| graph.zero())
    }

    fn half() -> Self {
        write(|graph| graph.constant(0.5))
    }

    fn one() -> Self {
        write(|graph| graph.one())
    }

    fn two() -> Self {
        write(|graph| graph.constant(2.0))
    }

    fn multiply_add(self, factor: Self, term: Self) -> Self {
        self * factor + term
    }
}
