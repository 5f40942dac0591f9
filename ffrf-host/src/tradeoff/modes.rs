//! Which modes a body has in a configuration.

use std::fmt;
use std::str::FromStr;

use ffrf_model::ModeSelection;

/// Modes of a body, or those of them that it has; counted from 0, as modal coordinates are.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Modes(Form);

/// Each choice has one form: a list that begins with 0 and leaves none out is the first so many.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Form {
    First(usize),
    Listed(Vec<usize>),
}

impl Modes {
    /// The first so many.
    pub fn first(count: usize) -> Self {
        Self(Form::First(count))
    }

    /// These, in the order of the model.
    pub fn listed(mut modes: Vec<usize>) -> Self {
        modes.sort_unstable();
        modes.dedup();
        let are_first = modes.iter().copied().eq(0..modes.len());
        Self(if are_first { Form::First(modes.len()) } else { Form::Listed(modes) })
    }

    /// How many, of a body that has them all.
    pub fn count(&self) -> usize {
        match &self.0 {
            Form::First(count) => *count,
            Form::Listed(modes) => modes.len(),
        }
    }

    /// Whether a mode is one of them.
    pub fn has(&self, mode: usize) -> bool {
        match &self.0 {
            Form::First(count) => mode < *count,
            Form::Listed(modes) => modes.binary_search(&mode).is_ok(),
        }
    }

    /// Those that a body of `available` modes has.
    pub fn of(&self, available: usize) -> Self {
        match &self.0 {
            Form::First(count) => Self::first(available.min(*count)),
            Form::Listed(modes) => {
                Self::listed(modes.iter().copied().filter(|mode| *mode < available).collect())
            }
        }
    }

    /// Their indices, of a body that has them all.
    pub fn indices(&self) -> Vec<usize> {
        match &self.0 {
            Form::First(count) => (0..*count).collect(),
            Form::Listed(modes) => modes.clone(),
        }
    }

    /// The list; none of the first so many.
    pub fn list(&self) -> Option<&[usize]> {
        match &self.0 {
            Form::First(_) => None,
            Form::Listed(modes) => Some(modes),
        }
    }

    /// As models and macros take it.
    pub fn selection(&self) -> ModeSelection {
        match &self.0 {
            Form::First(count) => ModeSelection::First(*count),
            Form::Listed(modes) => ModeSelection::Listed(modes.clone()),
        }
    }

    /// A name fit for files.
    pub(super) fn key(&self) -> String {
        match &self.0 {
            Form::First(count) => format!("m{count}"),
            Form::Listed(modes) => modes.iter().fold("m".to_owned(), |text, mode| format!("{text}.{mode}")),
        }
    }
}

impl From<usize> for Modes {
    fn from(count: usize) -> Self {
        Self::first(count)
    }
}

/// `4` for the first four, `[0, 5]` for a list.
impl fmt::Display for Modes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            // as a word, so that widths hold
            Form::First(count) => f.pad(&count.to_string()),
            Form::Listed(modes) => f.pad(&format!("{modes:?}")),
        }
    }
}

/// `4` or `..4` for the first four, `2..5` for a range, `[0, 5]` for a list, which may also be written `[0+5]`.
impl FromStr for Modes {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Ok(match text.replace('+', ",").parse()? {
            ModeSelection::First(count) => Self::first(count),
            ModeSelection::Range(start, end) if end <= MOST => Self::listed((start..end).collect()),
            ModeSelection::Listed(modes) => Self::listed(modes),
            _ => return Err(format!("`{text}`: expected modes below {MOST}")),
        })
    }
}

/// More modes than any body has: a range to beyond is a mistake, not a list to be made.
const MOST: usize = 100_000;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_choice_has_one_form_and_one_name() {
        let read = |text: &str| text.parse::<Modes>().unwrap();
        for (text, shown, key, count) in [
            ("4", "4", "m4", 4),
            ("..4", "4", "m4", 4),
            ("[2, 0, 1, 1]", "3", "m3", 3),
            ("0..2", "2", "m2", 2),
            ("[5]", "[5]", "m.5", 1),
            ("[5+0]", "[0, 5]", "m.0.5", 2),
            ("2..5", "[2, 3, 4]", "m.2.3.4", 3),
            ("[]", "0", "m0", 0),
        ] {
            let modes = read(text);
            assert_eq!(
                (modes.to_string().as_str(), modes.key().as_str(), modes.count()),
                (shown, key, count)
            );
            assert_eq!(read(shown), modes);
        }
        for text in ["", "-1", "[0", "x", "3..3", "0..100001"] {
            assert!(text.parse::<Modes>().is_err(), "{text}");
        }
    }

    #[test]
    fn a_body_has_those_of_them_that_it_has() {
        let (four, some) = (Modes::first(4), Modes::listed(vec![0, 2, 5]));
        assert_eq!((four.of(3), four.of(8)), (Modes::first(3), Modes::first(4)));
        assert_eq!((some.of(5), some.of(2)), (Modes::listed(vec![0, 2]), Modes::first(1)));
        assert!(some.has(2) && !some.has(1) && four.has(3) && !four.has(4));
        assert_eq!(some.indices(), [0, 2, 5]);
    }
}
