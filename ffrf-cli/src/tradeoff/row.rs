//! One line of the results: names and numbers of an outcome.

use ffrf_host::tradeoff::{Configuration, Measured, Outcome, front};

/// What is shown of an outcome.
pub struct Row<'a> {
    pub outcome: &'a Outcome,
    /// Whether no other is both cheaper and more exact, in time and in operations.
    pub on_front: [bool; 2],
}

impl Row<'_> {
    /// Errors and cost, of a run that reached its end.
    pub fn measured(&self) -> Option<&Measured> {
        self.outcome.measured()
    }
}

/// All outcomes, with those marked that nothing beats.
pub fn rows(outcomes: &[Outcome]) -> Vec<Row<'_>> {
    let points = |cost: fn(&Measured) -> f64| -> Vec<(f64, f64)> {
        let point = |outcome: &Outcome| {
            outcome.measured().map_or((f64::NAN, f64::NAN), |measured| (cost(measured), measured.error()))
        };
        outcomes.iter().map(point).collect()
    };
    let fronts =
        [points(|measured| measured.time), points(Measured::operations_per_second)].map(|p| front(&p));
    let rows = outcomes.iter().enumerate();
    rows.map(|(k, outcome)| Row { outcome, on_front: [0, 1].map(|cost| fronts[cost].contains(&k)) }).collect()
}

/// Width of the column of modes, which may name bodies. Units: characters.
pub fn modes_width<'a>(configurations: impl Iterator<Item = &'a Configuration>) -> usize {
    let widest = configurations.map(|one| one.modes.to_string().chars().count()).max();
    widest.unwrap_or(0).max("modes".len())
}
