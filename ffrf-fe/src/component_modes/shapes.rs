//! Shapes of a component basis before they are transformed, each with what made it.

use faer::Mat;
use ffrf_model::{Mode, ModeKind};

use super::frequency::hertz;
use super::normal_modes::NormalModes;

/// Shapes in coordinates y and where they come from.
#[derive(Clone)]
pub(crate) struct Shapes {
    /// Shape: n x p.
    pub columns: Mat<f64>,
    /// One per column.
    pub modes: Vec<Mode>,
}

impl Shapes {
    /// Shapes of one kind, without frequency.
    pub fn of_kind(columns: Mat<f64>, kind: ModeKind) -> Self {
        let modes = vec![Mode { kind, frequency_hz: None }; columns.ncols()];
        Self { columns, modes }
    }

    /// Normal modes of one kind.
    pub fn normal(modes: &NormalModes, kind: ModeKind) -> Self {
        let described = modes.values.iter().map(|&value| Mode { kind, frequency_hz: Some(hertz(value)) });
        Self { columns: modes.shapes.clone(), modes: described.collect() }
    }

    /// The shapes of these numbers.
    pub fn choose(&self, numbers: &[usize]) -> Self {
        Self {
            columns: Mat::from_fn(self.columns.nrows(), numbers.len(), |i, j| self.columns[(i, numbers[j])]),
            modes: numbers.iter().map(|&number| self.modes[number].clone()).collect(),
        }
    }

    /// These shapes and others behind them.
    pub fn and(self, other: Self) -> Self {
        let first = self.columns.ncols();
        let columns = Mat::from_fn(self.columns.nrows(), first + other.columns.ncols(), |i, j| {
            if j < first { self.columns[(i, j)] } else { other.columns[(i, j - first)] }
        });
        Self { columns, modes: self.modes.into_iter().chain(other.modes).collect() }
    }
}
