//! The units that documentation names: those of the model.

use ffrf_model::{ReducedBody, Units};

/// What stands before the units of a quantity in documentation.
const LABEL: &str = "Units: ";

/// Names of the units of a body. Kernels, constants and tables are documented in SI units; these replace them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct UnitNames {
    /// Replacements of SI names; empty for SI units.
    names: Vec<(&'static str, String)>,
}

impl UnitNames {
    /// Those of a model; SI units for invariants that come at run time, in whatever coherent units they are then.
    pub(super) fn of(model: Option<&ReducedBody>) -> Self {
        match model.map(|model| Units::of(&model.units)) {
            None | Some(Some(Units::SI)) => Self { names: Vec::new() },
            Some(Some(units)) => {
                let (mass, length, time) = (units.mass_name(), units.length_name(), units.time_name());
                let force = units.force_name();
                let energy = format!("{force} {length}");
                // Frequencies of the model are in hertz whatever the unit of time is.
                Self::new(mass, length, time, &force, &energy, "Hz")
            }
            Some(None) => Self::new("mass", "length", "time", "force", "force length", "1/time"),
        }
    }

    fn new(mass: &str, length: &str, time: &str, force: &str, energy: &str, frequency: &str) -> Self {
        let names =
            [("kg", mass), ("m", length), ("s", time), ("N", force), ("J", energy), ("Hz", frequency)];
        Self { names: names.map(|(si, name)| (si, name.to_owned())).to_vec() }
    }

    /// A line of documentation in these units: what follows `Units:`, up to the end of the sentence.
    pub(super) fn replace_in(&self, line: &str) -> String {
        let Some(start) = line.find(LABEL).map(|at| at + LABEL.len()).filter(|_| !self.names.is_empty())
        else {
            return line.to_owned();
        };
        let length = line[start..].find(". ").unwrap_or(line.len() - start);
        let (before, units, after) = (&line[..start], &line[start..start + length], &line[start + length..]);
        let mut replaced = String::new();
        let mut word = String::new();
        for character in units.chars().chain(['\n']) {
            // Exponents end a name: `m²`.
            if character.is_ascii_alphabetic() {
                word.push(character);
                continue;
            }
            match self.names.iter().find(|(si, _)| *si == word) {
                Some((_, name)) => replaced.push_str(name),
                None => replaced.push_str(&word),
            }
            word.clear();
            replaced.push(character);
        }
        format!("{before}{}{after}", replaced.trim_end_matches('\n'))
    }
}

#[cfg(test)]
mod tests {
    use super::UnitNames;

    #[test]
    fn names_of_units_are_replaced_and_other_words_are_not() {
        let names = UnitNames::new("t", "mm", "ms", "GN", "GN mm", "Hz");
        for (si, own) in [
            ("Mass m. Units: kg.", "Mass m. Units: t."),
            (
                "Shape: 8. Units: kg, kg m, kg m² and their modal kin. Frame: s.",
                "Shape: 8. Units: t, t mm, t mm² and their modal kin. Frame: s.",
            ),
            ("Units: m/s², rad/s², 1/s². Frame: body.", "Units: mm/ms², rad/ms², 1/ms². Frame: body."),
            ("Units: N, N m, modal forces", "Units: GN, GN mm, modal forces"),
            ("Units: J", "Units: GN mm"),
            ("Natural frequency. Units: Hz.", "Natural frequency. Units: Hz."),
            ("m b_μ, not a unit", "m b_μ, not a unit"),
        ] {
            assert_eq!(names.replace_in(si), own);
            assert_eq!(UnitNames::of(None).replace_in(si), si);
        }
    }
}
