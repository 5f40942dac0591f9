//! What was computed.

use std::cell::RefCell;

use ffrf_codegen::expression::{Expression, Graph};

pub use ffrf_codegen::{Call, Condition, Function, Relation};

/// The largest argument of a function, in nodes.
const LARGEST_ARGUMENT: usize = 8;

thread_local! {
    /// Where the numbers of this thread write.
    static TAPE: RefCell<Tape> = RefCell::default();
}

/// Every operation of a computation, and what it took for granted.
#[derive(Debug, Clone, Default)]
pub struct Tape {
    /// The operations.
    pub graph: Graph,
    /// Sines and cosines of what is small, angles of drives above all; their values are inputs of the graph.
    pub calls: Vec<Call>,
    /// Under which the operations are those of the traced code.
    pub conditions: Vec<Condition>,
    /// Functions of inputs that no node stands for, by name, each once; their values are not numbers.
    pub missing: Vec<&'static str>,
}

impl Tape {
    pub(crate) fn miss(&mut self, function: &'static str) {
        if !self.missing.contains(&function) {
            self.missing.push(function);
        }
    }

    /// The value of a function, which is an input of what follows; none of what is too large to be written in its place.
    pub(crate) fn call(&mut self, call: Call) -> Option<Expression> {
        let index = match self.calls.iter().position(|other| *other == call) {
            Some(index) => index,
            None if self.size(call.argument, LARGEST_ARGUMENT) > LARGEST_ARGUMENT => return None,
            None => {
                self.calls.push(call);
                self.calls.len() - 1
            }
        };
        Some(self.graph.symbol(Call::symbol(index)))
    }

    /// How many nodes an expression has as a tree, or more than `most`.
    fn size(&self, root: Expression, most: usize) -> usize {
        let mut sum = 1;
        for operand in self.graph.node(root).operands() {
            if sum > most {
                break;
            }
            sum += self.size(operand, most - sum.min(most));
        }
        sum
    }

    /// Takes for granted what just came out, unless two numbers or the same thing were compared.
    pub(crate) fn grant(&mut self, condition: Condition) {
        let is_number = |side: Expression| self.graph.constant_value(side).is_some();
        let is_open = condition.left != condition.right || condition.relation == Relation::Finite;
        if is_open
            && !(is_number(condition.left) && is_number(condition.right))
            && !self.conditions.contains(&condition)
        {
            self.conditions.push(condition);
        }
    }
}

pub(crate) fn write<R>(write: impl FnOnce(&mut Tape) -> R) -> R {
    TAPE.with_borrow_mut(write)
}

/// Runs `compute` on an empty tape of this thread; gives its result and the tape. What was on the tape is put back.
pub fn record<R>(compute: impl FnOnce() -> R) -> (R, Tape) {
    let before = TAPE.take();
    let result = compute();
    (result, TAPE.replace(before))
}
