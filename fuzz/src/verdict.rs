//! What must hold of the outcome of a reader.

use std::collections::HashSet;

use ffrf_fe::{FeModel, SparseMatrix};
use ffrf_model::ReducedBody;

/// Longest message: what is quoted of a file is cut.
const LONGEST_MESSAGE: usize = 4000;

/// What a reader made of an input.
#[derive(Debug)]
pub enum Outcome {
    /// The input is refused, with this message.
    Refused(String),
    /// A finite-element model, and its remarks.
    Model(Box<FeModel>, Vec<String>),
    /// Numbers of rows and columns, and whether all values are finite.
    Dense(usize, usize, bool),
    /// A reduced body.
    Body(Box<ReducedBody>),
}

impl Outcome {
    /// True if the input was accepted.
    pub fn is_accepted(&self) -> bool {
        !matches!(self, Self::Refused(_))
    }

    /// Panics if the message cannot be printed as it is, or the model contradicts itself.
    pub fn assert_sound(&self) {
        match self {
            Self::Refused(message) => assert_printable(message),
            Self::Model(model, remarks) => {
                remarks.iter().for_each(|remark| assert_printable(remark));
                assert_consistent(model);
            }
            Self::Dense(rows, columns, finite) => {
                assert!(
                    *rows == 6 && (1..=6).contains(columns) && *finite,
                    "{rows} x {columns}, finite: {finite}"
                );
            }
            Self::Body(body) => match body.check() {
                Ok(report) => report.checks.iter().for_each(|check| assert_printable(&check.to_string())),
                Err(error) => panic!("a body that was read has no shape: {error}"),
            },
        }
    }
}

fn assert_printable(message: &str) {
    assert!(!message.is_empty() && message.len() < LONGEST_MESSAGE, "a message of {} bytes", message.len());
    let control = message.chars().find(|&character| character.is_control() && character != '\n');
    assert_eq!(control, None, "{message:?}");
}

fn assert_consistent(model: &FeModel) {
    let nodes = model.nodes.len();
    assert!(nodes > 0 && model.nodes.positions.len() == nodes);
    assert!(model.nodes.positions.as_flattened().iter().all(|coordinate| coordinate.is_finite()));
    let ids: HashSet<u64> = model.nodes.ids.iter().copied().collect();
    assert_eq!(ids.len(), nodes, "node ids repeat");
    let inside = |rows: &[usize]| rows.iter().all(|&row| row < nodes);
    assert!(model.nodes.sets.values().all(|rows| inside(rows)));
    assert!(model.elements.iter().all(|element| inside(&element.nodes)));
    assert!(model.fixed_dofs.iter().all(|&dof| dof < 3 * nodes));
    assert_symmetric(&model.mass, nodes);
    if let Some(stiffness) = &model.stiffness {
        assert_symmetric(stiffness, 3 * nodes);
    }
    let total: f64 = model.mass.val().iter().sum();
    assert!(total.is_finite() && total > 0.0, "total mass {total}");
}

fn assert_symmetric(matrix: &SparseMatrix, size: usize) {
    assert_eq!((matrix.nrows(), matrix.ncols()), (size, size));
    for entry in matrix.triplet_iter() {
        assert!(entry.val.is_finite());
        assert_eq!(matrix.get(entry.col, entry.row), Some(entry.val), "({}, {})", entry.row, entry.col);
    }
}
