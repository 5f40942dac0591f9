//! From a validated kernel to its listing: what gets a name, and what is written inside something else.

use super::names::Names;
use super::{Listing, Operation, Section, Statement, Tree};
use crate::counts::OperationCounts;
use crate::expression::{Expression, Node};
use crate::passes::use_counts;
use crate::validate::ValidKernel;

/// Longest expression that is written inside another one, in characters.
const LONGEST_INLINE: usize = 60;

/// The listing of a kernel; `width` is the number of characters that a tree takes in print.
///
/// An operation becomes a statement if it is used more than once, has a name, or is too long to stand in its place.
pub(in crate::emit) fn listing(kernel: &ValidKernel, width: impl Fn(&Tree) -> usize) -> Listing {
    let kernel = kernel.kernel();
    let graph = &kernel.graph;
    let uses = use_counts(kernel);
    let mut names = Names::new(kernel, &uses);
    let mut sections: Vec<Section> = Vec::new();
    // Of a validated kernel every operand stands before its node.
    let mut trees: Vec<Tree> = Vec::with_capacity(uses.len());
    for (handle, node) in graph.nodes().take(uses.len()) {
        let uses = uses[handle.index()];
        let at = |operand: Expression| trees[operand.index()].clone();
        let binary = |operation, a, b| Tree::Binary(operation, Box::new([at(a), at(b)]));
        let tree = match node {
            // Nothing refers to it.
            _ if uses == 0 => Tree::Number(0.0),
            Node::Constant(constant) => Tree::Number(constant.value()),
            Node::Symbol(symbol) => Tree::Symbol(symbol),
            Node::Negate(a) => Tree::Negate(Box::new(at(a))),
            Node::Add(a, b) => binary(Operation::Add, a, b),
            Node::Subtract(a, b) => binary(Operation::Subtract, a, b),
            Node::Multiply(a, b) => binary(Operation::Multiply, a, b),
            Node::Divide(a, b) => binary(Operation::Divide, a, b),
            Node::MultiplyAdd(a, b, c) => Tree::MultiplyAdd(Box::new([at(a), at(b), at(c)])),
            Node::SquareRoot(a) => Tree::SquareRoot(Box::new(at(a))),
        };
        if uses == 0 || !node.is_operation() {
            trees.push(tree);
            continue;
        }
        let section = section(&mut sections, graph.section_of(handle));
        section.counts.add(node);
        let is_named = graph.label_of(handle).is_some();
        if uses > 1 || is_named || width(&tree) > LONGEST_INLINE {
            let name = names.of(handle);
            section.statements.push(Statement { name: name.clone(), value: tree });
            trees.push(Tree::Name(name));
        } else {
            trees.push(tree);
        }
    }
    Listing {
        signature: kernel.signature,
        mode_count: kernel.mode_count,
        counts: OperationCounts::of(kernel),
        sections,
        results: kernel.outputs.iter().map(|output| trees[output.index()].clone()).collect(),
    }
}

fn section<'a>(sections: &'a mut Vec<Section>, heading: &str) -> &'a mut Section {
    let position = sections.iter().position(|section| section.heading == heading);
    let position = position.unwrap_or_else(|| {
        let (counts, statements) = (OperationCounts::default(), Vec::new());
        sections.push(Section { heading: heading.to_owned(), counts, statements });
        sections.len() - 1
    });
    &mut sections[position]
}
