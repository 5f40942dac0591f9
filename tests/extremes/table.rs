//! What was measured, as rows of a table: what is guaranteed, and what came of it in both number types.

use std::fmt;

use ffrf::nalgebra::RealField;

/// Two number types, so that every extreme is stood at in both.
pub trait Real: RealField + Copy {
    /// Whether it is the one of single precision.
    const SINGLE: bool;

    /// The number that is nearest to one of double precision.
    fn of(number: f64) -> Self {
        ffrf::nalgebra::convert(number)
    }

    /// As a number of double precision.
    fn double(self) -> f64;
}

impl Real for f64 {
    const SINGLE: bool = false;

    fn double(self) -> f64 {
        self
    }
}

impl Real for f32 {
    const SINGLE: bool = true;

    fn double(self) -> f64 {
        self.into()
    }
}

/// What came of one extreme in one number type.
#[derive(Debug, Clone, PartialEq)]
pub enum Figure {
    /// A size, and what it must stay below.
    Below { found: f64, bound: f64 },
    /// The numbers are the same to the last bit, or something else holds that is no number.
    Holds(&'static str),
    /// An error value says this.
    Refused(String),
}

/// A size that must stay below the bound of its number type: double, single.
pub fn below<T: Real>(found: f64, [double, single]: [f64; 2]) -> Figure {
    Figure::Below { found, bound: if T::SINGLE { single } else { double } }
}

/// What an error says, with the number of the last decimals that differ between machines cut off.
pub fn refused(error: impl fmt::Display) -> Figure {
    Figure::Refused(error.to_string())
}

impl fmt::Display for Figure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Below { found, bound } if *found == 0.0 => write!(f, "0 < {bound:.0e}"),
            Self::Below { found, bound } => write!(f, "{found:.0e} < {bound:.0e}"),
            Self::Holds(what) => f.write_str(what),
            Self::Refused(text) => write!(f, "refused: {text}"),
        }
    }
}

/// One extreme: double and single precision side by side.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    pub case: String,
    pub figures: [Figure; 2],
}

/// Rows that one text explains.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    pub title: &'static str,
    /// What is done and what is guaranteed.
    pub text: &'static str,
    pub rows: Vec<Row>,
}

/// A row of one case that `measure` stands at in both number types.
#[macro_export]
macro_rules! row {
    ($case:expr, $measure:ident $(, $argument:expr)* $(,)?) => {
        $crate::table::Row {
            case: ($case).to_string(),
            figures: [$measure::<f64>($($argument),*), $measure::<f32>($($argument),*)],
        }
    };
}

impl Section {
    /// Every figure is below its bound.
    pub fn check(&self) {
        let mut offences = Vec::new();
        for row in &self.rows {
            for (figure, scalar) in row.figures.iter().zip(["f64", "f32"]) {
                eprintln!("{}: {}: {scalar}: {figure}", self.title, row.case);
                if let Figure::Below { found, bound } = figure
                    && (found.is_nan() || found > bound)
                {
                    offences.push(format!("{}: {scalar}: {found:e} is not below {bound:e}", row.case));
                }
            }
        }
        assert!(offences.is_empty(), "{}:\n{}", self.title, offences.join("\n"));
    }
}

impl fmt::Display for Section {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "## {}\n\n{}\n", self.title, self.text)?;
        writeln!(f, "| case | f64 | f32 |\n| --- | --- | --- |")?;
        for row in &self.rows {
            let [double, single] = &row.figures;
            writeln!(f, "| {} | {double} | {single} |", row.case)?;
        }
        Ok(())
    }
}
