//! What stands between a graph and its text: sections, statements and expression trees, for any language.

mod build;
mod names;

pub(super) use build::listing;

use std::collections::BTreeSet;

use crate::counts::OperationCounts;
use crate::expression::Symbol;
use crate::formulate::Signature;

/// A kernel as it is to be printed.
#[derive(Debug, Clone)]
pub(super) struct Listing {
    /// Arguments, results and documentation.
    pub(super) signature: Signature,
    /// Number of modes M.
    pub(super) mode_count: usize,
    /// Operations of one call.
    pub(super) counts: OperationCounts,
    /// Statements, in order.
    pub(super) sections: Vec<Section>,
    /// The results, one after another; matrices column by column.
    pub(super) results: Vec<Tree>,
}

/// Statements below one heading.
#[derive(Debug, Clone)]
pub(super) struct Section {
    /// Its heading, may be empty.
    pub(super) heading: String,
    /// Operations of all its statements.
    pub(super) counts: OperationCounts,
    /// The statements.
    pub(super) statements: Vec<Statement>,
}

/// A temporary and its value.
#[derive(Debug, Clone)]
pub(super) struct Statement {
    /// Name of the temporary.
    pub(super) name: String,
    /// Its value.
    pub(super) value: Tree,
}

/// An expression.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Tree {
    /// A number.
    Number(f64),
    /// An input of the kernel or an invariant.
    Symbol(Symbol),
    /// A temporary.
    Name(String),
    /// -a
    Negate(Box<Self>),
    /// An operation on two operands.
    Binary(Operation, Box<[Self; 2]>),
    /// a b + c
    MultiplyAdd(Box<[Self; 3]>),
    /// √a
    SquareRoot(Box<Self>),
}

/// An operation on two operands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Operation {
    /// a + b
    Add,
    /// a - b
    Subtract,
    /// a b
    Multiply,
    /// a / b
    Divide,
}

impl Tree {
    fn operands(&self) -> &[Self] {
        match self {
            Self::Number(_) | Self::Symbol(_) | Self::Name(_) => &[],
            Self::Negate(a) | Self::SquareRoot(a) => std::slice::from_ref(a),
            Self::Binary(_, operands) => operands.as_slice(),
            Self::MultiplyAdd(operands) => operands.as_slice(),
        }
    }

    pub(super) fn visit<'a>(&'a self, look: &mut impl FnMut(&'a Self)) {
        look(self);
        for operand in self.operands() {
            operand.visit(look);
        }
    }
}

/// What the trees of a listing need from around them.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Needs {
    /// Entries of inputs and invariants.
    pub(super) symbols: BTreeSet<Symbol>,
    /// Numbers.
    pub(super) numbers: bool,
    /// a b + c as one operation.
    pub(super) multiply_add: bool,
    /// Square roots.
    pub(super) square_root: bool,
}

impl Needs {
    /// Whether an invariant is needed.
    pub(super) fn invariants(&self) -> bool {
        self.symbols.iter().any(|symbol| symbol.is_parameter())
    }
}

impl Listing {
    /// What all statements and results need.
    pub(super) fn needs(&self) -> Needs {
        let mut needs = Needs::default();
        let statements = self.sections.iter().flat_map(|section| &section.statements);
        for tree in statements.map(|statement| &statement.value).chain(&self.results) {
            tree.visit(&mut |tree| match tree {
                Tree::Number(_) => needs.numbers = true,
                Tree::MultiplyAdd(_) => needs.multiply_add = true,
                Tree::SquareRoot(_) => needs.square_root = true,
                Tree::Symbol(symbol) => {
                    needs.symbols.insert(*symbol);
                }
                Tree::Name(_) | Tree::Negate(_) | Tree::Binary(..) => {}
            });
        }
        needs
    }
}
