//! Entries in nested arrays.

use crate::expression::{Expression, Graph};

/// Entries in nested arrays of a fixed shape, the last index fastest: what a `static` of the generated code holds.
#[derive(Debug, Clone, PartialEq)]
pub struct Table<V = f64> {
    shape: Vec<usize>,
    entries: Vec<V>,
}

impl<V> Table<V> {
    /// The table with the entry `at(index)` for every index within `shape`.
    pub(crate) fn new<const D: usize>(shape: [usize; D], at: impl Fn([usize; D]) -> V) -> Self {
        let count = shape.iter().product();
        let mut entries = Vec::with_capacity(count);
        let mut index = [0; D];
        for _ in 0..count {
            entries.push(at(index));
            for axis in (0..D).rev() {
                index[axis] += 1;
                if index[axis] < shape[axis] {
                    break;
                }
                index[axis] = 0;
            }
        }
        Self { shape: shape.to_vec(), entries }
    }

    /// The lengths of the arrays, the outermost first.
    pub fn shape(&self) -> &[usize] {
        &self.shape
    }

    /// All entries, those of an innermost array side by side.
    pub fn entries(&self) -> &[V] {
        &self.entries
    }
}

impl Table<Expression> {
    pub(super) fn numbers(&self, graph: &Graph) -> Table {
        let entries = self.entries.iter().map(|entry| number(graph, *entry)).collect();
        Table { shape: self.shape.clone(), entries }
    }
}

/// A symmetric matrix over the modes.
#[derive(Debug, Clone, PartialEq)]
pub enum ModalMatrix<V = f64> {
    /// Nothing.
    Zero,
    /// Ones.
    Identity,
    /// These entries. Shape: groups, lanes (4).
    Diagonal(Table<V>),
    /// All entries. Shape: groups, modes ν, lanes (4) over μ.
    Dense(Table<V>),
}

impl ModalMatrix<Expression> {
    pub(super) fn numbers(&self, graph: &Graph) -> ModalMatrix {
        match self {
            Self::Zero => ModalMatrix::Zero,
            Self::Identity => ModalMatrix::Identity,
            Self::Diagonal(entries) => ModalMatrix::Diagonal(entries.numbers(graph)),
            Self::Dense(entries) => ModalMatrix::Dense(entries.numbers(graph)),
        }
    }
}

/// Θ_ff = L D Lᵀ with ones on the diagonal of L.
#[derive(Debug, Clone, PartialEq)]
pub enum ModalFactors<V = f64> {
    /// Θ_ff = I.
    Identity,
    /// L = I, and 1 / D. Shape: groups, lanes (4).
    Diagonal(Table<V>),
    /// A dense Θ_ff.
    Triangular {
        /// 1 / D. Shape: groups, lanes (4).
        inverse_pivots: Table<V>,
        /// L + Lᵀ without its diagonal. Shape: groups, modes ν, lanes (4) over μ.
        lower: Table<V>,
    },
}

impl ModalFactors<Expression> {
    pub(super) fn numbers(&self, graph: &Graph) -> ModalFactors {
        match self {
            Self::Identity => ModalFactors::Identity,
            Self::Diagonal(entries) => ModalFactors::Diagonal(entries.numbers(graph)),
            Self::Triangular { inverse_pivots, lower } => ModalFactors::Triangular {
                inverse_pivots: inverse_pivots.numbers(graph),
                lower: lower.numbers(graph),
            },
        }
    }
}

/// The value of a constant; of anything else, which generated tables do not hold, not a number.
pub(super) fn number(graph: &Graph, expression: Expression) -> f64 {
    graph.constant_value(expression).unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::Table;

    #[test]
    fn the_last_index_is_fastest() {
        let table = Table::new([2, 1, 3], |[i, j, k]| (100 * i + 10 * j + k) as f64);
        assert_eq!(table.entries(), [0.0, 1.0, 2.0, 100.0, 101.0, 102.0]);
        assert_eq!(table.shape(), [2, 1, 3]);
        assert!(Table::new([0, 4], |_| 1.0).entries().is_empty());
    }
}
