//! Names of temporaries: the formulation's word where there is one, a number otherwise.

use std::collections::BTreeSet;

use crate::expression::{Expression, Node};
use crate::formulate::Kernel;

/// The name of each node of a kernel that may be printed as a statement.
#[derive(Debug, Clone)]
pub(super) struct Names {
    names: Vec<Option<String>>,
    numbered: usize,
}

impl Names {
    /// Takes labels as names, made unique; a running sum that serves nothing else has its total's name.
    pub(super) fn new(kernel: &Kernel, uses: &[usize]) -> Self {
        let graph = &kernel.graph;
        let mut taken: BTreeSet<String> = BTreeSet::new();
        let mut names: Vec<Option<String>> = vec![None; uses.len()];
        for (handle, _) in graph.nodes().take(uses.len()) {
            if let Some(label) = graph.label_of(handle).filter(|_| uses[handle.index()] > 0) {
                let mut name = label.to_owned();
                let mut copy = 2;
                while !taken.insert(name.clone()) {
                    name = format!("{label}_{copy}");
                    copy += 1;
                }
                names[handle.index()] = Some(name);
            }
        }
        for (handle, node) in graph.nodes().take(uses.len()).collect::<Vec<_>>().into_iter().rev() {
            let Some(name) = names[handle.index()].clone() else { continue };
            let partial = |operand: &Expression| {
                let index = operand.index();
                uses[index] == 1
                    && names[index].is_none()
                    && matches!(
                        graph.node(*operand),
                        Node::Add(..) | Node::Subtract(..) | Node::MultiplyAdd(..)
                    )
            };
            let candidates = match node {
                Node::Add(a, b) => vec![a, b],
                Node::Subtract(a, _) => vec![a],
                Node::MultiplyAdd(_, _, c) => vec![c],
                _ => vec![],
            };
            if let Some(rest) = candidates.into_iter().find(|operand| partial(operand)) {
                names[rest.index()] = Some(name);
            }
        }
        Self { names, numbered: 0 }
    }

    /// The name of a node that is printed as a statement.
    pub(super) fn of(&mut self, handle: Expression) -> String {
        match self.names.get(handle.index()).and_then(Option::as_ref) {
            Some(name) => name.clone(),
            None => {
                self.numbered += 1;
                format!("t{}", self.numbered)
            }
        }
    }
}
