//! A curve through given points: the natural cubic spline, twice continuously differentiable.

use thiserror::Error;

/// A natural cubic spline; beyond its ends it goes on along its tangents.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    times: Vec<f64>,
    values: Vec<f64>,
    /// Second derivatives at the points.
    curvatures: Vec<f64>,
}

/// Why a table is refused.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum TableError {
    /// A line is not two numbers.
    #[error("line {line}: expected two finite numbers, time and value, found `{found}`")]
    Line {
        /// The line, from 1.
        line: usize,
        /// What stands there.
        found: String,
    },
    /// Times do not increase.
    #[error("line {line}: expected a time after {before}, found {found}")]
    Order {
        /// The line, from 1.
        line: usize,
        /// The time before.
        before: f64,
        /// The time found.
        found: f64,
    },
    /// Too few points.
    #[error("expected at least two points, found {found}")]
    Short {
        /// Number of points.
        found: usize,
    },
}

impl Table {
    /// Reads lines of time (s) and value, separated by a comma or blanks; lines that begin with `#` are comments.
    pub fn parse(text: &str) -> Result<Self, TableError> {
        let (mut times, mut values): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
        for (index, line) in text.lines().enumerate() {
            let line = line.trim();
            if line.is_empty() || line.starts_with('#') {
                continue;
            }
            let numbers: Vec<f64> = line
                .split(|c: char| c == ',' || c.is_whitespace())
                .filter(|part| !part.is_empty())
                .map(|part| part.parse().unwrap_or(f64::NAN))
                .collect();
            let [time, value] = numbers[..] else {
                return Err(TableError::Line { line: index + 1, found: shown(line) });
            };
            if !(time.is_finite() && value.is_finite()) {
                return Err(TableError::Line { line: index + 1, found: shown(line) });
            }
            if let Some(before) = times.last().filter(|before| time <= **before) {
                return Err(TableError::Order { line: index + 1, before: *before, found: time });
            }
            times.push(time);
            values.push(value);
        }
        if times.len() < 2 {
            return Err(TableError::Short { found: times.len() });
        }
        let curvatures = curvatures(&times, &values);
        Ok(Self { times, values, curvatures })
    }

    /// Value, rate and acceleration at `time` (s).
    pub fn at(&self, time: f64) -> [f64; 3] {
        let last = self.times.len() - 1;
        let inside = time.clamp(self.times[0], self.times[last]);
        let k = self.times[1..last].partition_point(|start| *start <= inside);
        let h = self.times[k + 1] - self.times[k];
        let (a, b) = ((self.times[k + 1] - inside) / h, (inside - self.times[k]) / h);
        let (left, right) = (self.curvatures[k], self.curvatures[k + 1]);
        let value = a * self.values[k]
            + b * self.values[k + 1]
            + ((a * a * a - a) * left + (b * b * b - b) * right) * h * h / 6.0;
        let rate = (self.values[k + 1] - self.values[k]) / h
            + ((1.0 - 3.0 * a * a) * left + (3.0 * b * b - 1.0) * right) * h / 6.0;
        if inside == time {
            [value, rate, a * left + b * right]
        } else {
            [value + rate * (time - inside), rate, 0.0]
        }
    }
}

fn shown(line: &str) -> String {
    line.chars().take(40).flat_map(char::escape_debug).collect()
}

/// Second derivatives of the natural spline: a tridiagonal system, diagonally dominant.
fn curvatures(times: &[f64], values: &[f64]) -> Vec<f64> {
    let count = times.len();
    let mut curvatures = vec![0.0; count];
    let mut upper = vec![0.0; count];
    for k in 1..count - 1 {
        let (before, after) = (times[k] - times[k - 1], times[k + 1] - times[k]);
        let right = 6.0 * ((values[k + 1] - values[k]) / after - (values[k] - values[k - 1]) / before);
        let pivot = 2.0 * (before + after) - before * upper[k - 1];
        upper[k] = after / pivot;
        curvatures[k] = (right - before * curvatures[k - 1]) / pivot;
    }
    for k in (1..count - 1).rev() {
        curvatures[k] -= upper[k] * curvatures[k + 1];
    }
    curvatures
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spline_meets_its_points_and_its_derivatives() {
        let text: String =
            (0..=40).map(|k| format!("{} {}\n", 0.1 * k as f64, (0.1 * k as f64).sin())).collect();
        let table = Table::parse(&text).unwrap();
        // the natural spline is of fourth order inside: h⁴ = 1e-4 times small constants
        let [value, rate, acceleration] = table.at(1.23);
        assert!((value - 1.23_f64.sin()).abs() < 1e-6);
        assert!((rate - 1.23_f64.cos()).abs() < 1e-4);
        assert!((acceleration + 1.23_f64.sin()).abs() < 1e-2);
        assert!((table.at(0.7)[0] - 0.7_f64.sin()).abs() < 1e-14);
    }

    #[test]
    fn bad_tables_are_refused_with_their_line() {
        assert_eq!(Table::parse("0 1\n1 x\n"), Err(TableError::Line { line: 2, found: "1 x".to_owned() }));
        assert_eq!(
            Table::parse("# t v\n0,1\n0,2\n"),
            Err(TableError::Order { line: 3, before: 0.0, found: 0.0 })
        );
        assert_eq!(Table::parse("0 1\n"), Err(TableError::Short { found: 1 }));
    }
}
