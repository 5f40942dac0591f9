//! One line of the results: names and numbers of an outcome.

use ffrf_codegen::ScalarType;
use ffrf_host::tradeoff::{Finding, Measured, Outcome, front};

/// What is shown of an outcome.
pub struct Row<'a> {
    pub outcome: &'a Outcome,
    /// Whether no other is both cheaper and more exact, in time and in operations.
    pub on_front: [bool; 2],
}

impl Row<'_> {
    /// Errors and cost, of a run that reached its end.
    pub fn measured(&self) -> Option<&Measured> {
        match &self.outcome.finding {
            Finding::Finished(measured) => Some(measured),
            Finding::Failed(_) => None,
        }
    }

    /// Size of a number. Units: bytes.
    fn number_size(&self) -> usize {
        if self.outcome.configuration.scalar == ScalarType::F32 { 4 } else { 8 }
    }

    /// Numbers of the bodies in compiled code. Units: bytes.
    pub fn data_bytes(&self) -> Option<usize> {
        self.measured().map(|measured| measured.cost.constants * self.number_size())
    }

    /// What a step keeps on the stack, estimated. Units: bytes.
    pub fn stack_bytes(&self) -> Option<usize> {
        self.measured().map(|measured| measured.cost.stack_numbers * self.number_size())
    }
}

/// All outcomes, with those marked that nothing beats.
pub fn rows(outcomes: &[Outcome]) -> Vec<Row<'_>> {
    let points = |cost: fn(&Measured) -> f64| -> Vec<(f64, f64)> {
        let point = |outcome: &Outcome| match &outcome.finding {
            Finding::Finished(measured) => (cost(measured), measured.error()),
            Finding::Failed(_) => (f64::NAN, f64::NAN),
        };
        outcomes.iter().map(point).collect()
    };
    let fronts =
        [points(|measured| measured.time), points(Measured::operations_per_second)].map(|p| front(&p));
    let rows = outcomes.iter().enumerate();
    rows.map(|(k, outcome)| Row { outcome, on_front: [0, 1].map(|cost| fronts[cost].contains(&k)) }).collect()
}
