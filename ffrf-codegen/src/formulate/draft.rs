//! A graph with what its formulation says to a reader: headings and names of temporaries.

use std::collections::BTreeMap;
use std::ops::{Deref, DerefMut};

use crate::expression::{Expression, Graph};

/// A graph while it is formulated, and afterwards: the notes go along through all passes.
#[derive(Debug, Clone, Default)]
pub struct Draft {
    graph: Graph,
    /// Index of the first node below each heading, ascending.
    headings: Vec<(usize, String)>,
    names: BTreeMap<Expression, String>,
}

impl Draft {
    /// A draft that goes on with `graph`.
    pub fn new(graph: Graph) -> Self {
        Self { graph, ..Self::default() }
    }

    /// Names a temporary: a word, and where needed a mode number and axes. The first name stays; constants, symbols and
    /// changes of sign take none.
    pub fn label(&mut self, expression: Expression, name: impl Into<String>) -> Expression {
        if self.graph.node(expression).is_operation() {
            self.names.entry(expression).or_insert_with(|| name.into());
        }
        expression
    }

    /// The name of a temporary, if it has one.
    pub fn label_of(&self, expression: Expression) -> Option<&str> {
        self.names.get(&expression).map(String::as_str)
    }

    /// Opens a section: nodes inserted from now on belong to it.
    ///
    /// A section must not be opened again once a later one has nodes: the emitter prints sections one after another.
    pub fn section(&mut self, heading: &str) {
        let start = self.graph.len();
        if self.headings.last().is_some_and(|(index, _)| *index == start) {
            self.headings.pop();
        }
        if self.headings.last().is_none_or(|(_, last)| last != heading) {
            self.headings.push((start, heading.to_owned()));
        }
    }

    /// All that `write` inserts as one section, whatever sections it opens: for formulations that are a part of another.
    pub fn within_section<R>(&mut self, heading: &str, write: impl FnOnce(&mut Self) -> R) -> R {
        self.section(heading);
        let kept = self.headings.len();
        // The heading stays even if what follows opens a section before it inserts a node.
        let own = self.headings.last().cloned();
        let result = write(self);
        self.headings.truncate(kept.saturating_sub(1));
        self.headings.extend(own);
        result
    }

    /// Heading of the section that a node belongs to; empty if none was opened.
    pub fn section_of(&self, expression: Expression) -> &str {
        let later = self.headings.partition_point(|(start, _)| *start <= expression.index());
        later.checked_sub(1).and_then(|position| self.headings.get(position)).map_or("", |(_, name)| name)
    }
}

impl Deref for Draft {
    type Target = Graph;

    fn deref(&self) -> &Graph {
        &self.graph
    }
}

impl DerefMut for Draft {
    fn deref_mut(&mut self) -> &mut Graph {
        &mut self.graph
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::Input;

    #[test]
    fn sections_and_labels_stay_with_their_nodes() {
        let mut draft = Draft::default();
        draft.section("first");
        let x = draft.symbol(Input::COORDINATES.symbol(0));
        let square = draft.multiply(x, x);
        draft.section("second");
        draft.label(square, "square");
        draft.label(x, "never");
        let again = draft.multiply(x, x);
        assert_eq!(draft.section_of(again), "first");
        assert_eq!(draft.label_of(again), Some("square"));
        assert_eq!(draft.label_of(x), None);
    }

    #[test]
    fn a_formulation_within_another_opens_no_sections() {
        let mut draft = Draft::default();
        let x = draft.symbol(Input::COORDINATES.symbol(0));
        let [square, cube] = draft.within_section("outer", |draft| {
            draft.section("inner");
            let square = draft.multiply(x, x);
            draft.section("innermost");
            [square, draft.multiply(square, x)]
        });
        draft.section("after");
        let fourth = draft.multiply(cube, x);
        assert_eq!(
            [x, square, cube, fourth].map(|node| draft.section_of(node)),
            ["", "outer", "outer", "after"]
        );
    }
}
