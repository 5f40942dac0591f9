//! Functions on arrays: any computation in straight-line code, with what it takes for granted.
//!
//! Kernels of bodies have inputs of their own and are formulated here; an array function is an expression graph that comes
//! from elsewhere, as that of a whole mechanism.

mod call;
mod condition;

pub use call::{Call, Function};
pub use condition::{Condition, Relation};

use crate::expression::{Expression, Graph, Symbol, evaluate};

/// How the entries of an input stand in its argument.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum InputForm {
    /// The only one, by value.
    Number,
    /// One behind the other.
    Flat,
    /// In inner arrays of so many.
    Nested(usize),
}

/// An array of inputs, or one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ArrayInput {
    /// Name of the argument.
    pub name: &'static str,
    /// What the name of an entry begins with; its number follows.
    pub entry: &'static str,
    /// Number of entries.
    pub count: usize,
    /// How they stand there.
    pub form: InputForm,
}

impl ArrayInput {
    /// Entry `index`, counted through.
    pub fn symbol(&self, index: usize) -> Symbol {
        Symbol::Intermediate(self.entry, index)
    }
}

/// A function on arrays in straight-line code.
#[derive(Debug, Clone)]
pub struct ArrayFunction {
    /// Its name.
    pub name: String,
    /// Lines of its documentation.
    pub documentation: Vec<String>,
    /// What it takes.
    pub inputs: Vec<ArrayInput>,
    /// The name of the argument that takes its results.
    pub output: &'static str,
    /// Every operation.
    pub graph: Graph,
    /// Values of functions, which are inputs of the graph.
    pub calls: Vec<Call>,
    /// The results.
    pub results: Vec<Expression>,
    /// Under which the results are right.
    pub conditions: Vec<Condition>,
}

impl ArrayFunction {
    /// The results for such inputs, by interpreting every operation as it is, and whether the conditions hold.
    pub fn interpret(&self, input: impl Fn(Symbol) -> f64) -> (Vec<f64>, bool) {
        let mut values: Vec<f64> = Vec::with_capacity(self.calls.len());
        let of = |values: &[f64], expressions: &[Expression]| {
            evaluate(&self.graph, expressions, |symbol| match symbol {
                Symbol::Intermediate(Call::ENTRY, index) => values.get(index).copied().unwrap_or(f64::NAN),
                symbol => input(symbol),
            })
        };
        for call in &self.calls {
            let argument = of(&values, &[call.argument]);
            values.push(argument.first().map_or(f64::NAN, |argument| call.function.of(*argument)));
        }
        let sides = self.conditions.iter().flat_map(|condition| [condition.left, condition.right]);
        let all: Vec<Expression> = self.results.iter().copied().chain(sides).collect();
        let mut results = of(&values, &all);
        let sides = results.split_off(self.results.len());
        let mut conditions = self.conditions.iter().zip(sides.chunks(2));
        let holds = conditions.all(|(condition, sides)| match sides {
            [left, right] => condition.relation.holds(*left, *right),
            _ => false,
        });
        (results, holds)
    }
}
