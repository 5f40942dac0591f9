//! Times by number of modes, as a Markdown table.

use std::fmt;

use crate::timing::Time;

/// One row per column that was timed, one entry per number of modes.
pub struct Table {
    title: String,
    modes: Vec<usize>,
    rows: Vec<(String, Vec<(usize, Time)>)>,
    ratios: Vec<(String, Vec<(usize, f64)>)>,
}

impl Table {
    /// An empty table.
    pub fn new(title: &str) -> Self {
        Self { title: title.to_owned(), modes: Vec::new(), rows: Vec::new(), ratios: Vec::new() }
    }

    /// Adds an entry to the row of that name.
    pub fn add(&mut self, modes: usize, name: &str, time: Time) {
        if !self.modes.contains(&modes) {
            self.modes.push(modes);
        }
        match self.rows.iter_mut().find(|(row, _)| row == name) {
            Some((_, times)) => times.push((modes, time)),
            None => self.rows.push((name.to_owned(), vec![(modes, time)])),
        }
    }

    /// Adds a row of ratios of medians.
    pub fn add_ratio(&mut self, name: &str, numerator: &str, denominator: &str) {
        let times = |wanted: &str| {
            let row = self.rows.iter().find(|(row, _)| row == wanted);
            &row.unwrap_or_else(|| panic!("a row called {wanted}")).1
        };
        let ratios = times(numerator)
            .iter()
            .zip(times(denominator))
            .map(|((modes, above), (_, below))| (*modes, above.median / below.median));
        self.ratios.push((name.to_owned(), ratios.collect()));
    }
}

impl fmt::Display for Table {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(formatter, "## {}\n", self.title)?;
        write!(formatter, "| modes |")?;
        self.modes.iter().try_for_each(|modes| write!(formatter, " {modes} |"))?;
        writeln!(formatter, "\n|---|{}", "---|".repeat(self.modes.len()))?;
        for (name, times) in &self.rows {
            write!(formatter, "| {name} |")?;
            for (_, time) in times {
                write!(formatter, " {:.0} ({:.0}) |", time.median, time.minimum)?;
            }
            writeln!(formatter)?;
        }
        for (name, ratios) in &self.ratios {
            write!(formatter, "| {name} |")?;
            ratios.iter().try_for_each(|(_, ratio)| write!(formatter, " {ratio:.2} |"))?;
            writeln!(formatter)?;
        }
        Ok(())
    }
}
