//! The units that the numbers of a body are in: three names, and what follows from them.

use std::fmt;
use std::str::FromStr;

/// What [`ReducedBody::units`](crate::ReducedBody::units) says when nobody said which units the numbers are in.
pub const UNKNOWN_UNITS: &str = "unknown";

/// Names and values of units. The first name of each value is the one that is printed.
type Table = &'static [(&'static str, f64)];

/// Units: m.
const LENGTHS: Table =
    &[("m", 1.0), ("mm", 1e-3), ("cm", 1e-2), ("um", 1e-6), ("km", 1e3), ("in", 0.0254), ("ft", 0.3048)];
/// Units: kg. `slinch` is the mass that one pound-force accelerates by one inch per second squared.
const MASSES: Table = &[
    ("kg", 1.0),
    ("t", 1e3),
    ("tonne", 1e3),
    ("g", 1e-3),
    ("mg", 1e-6),
    ("lb", POUND),
    ("slug", POUND_FORCE / 0.3048),
    ("slinch", POUND_FORCE / 0.0254),
];
/// Units: s.
const TIMES: Table = &[("s", 1.0), ("ms", 1e-3), ("us", 1e-6)];
/// Units: N. A force that is none of these is written as mass times length over time squared.
const FORCES: Table =
    &[("N", 1.0), ("mN", 1e-3), ("uN", 1e-6), ("kN", 1e3), ("MN", 1e6), ("GN", 1e9), ("lbf", POUND_FORCE)];

const POUND: f64 = 0.453_592_37;
const POUND_FORCE: f64 = POUND * 9.806_65;

/// Relative difference of two values of the same force unit: round-off of a few products.
const SAME: f64 = 1e-12;

/// A coherent set of units: length, mass and time; the unit of force follows from them.
///
/// Written `m, kg, s, N` or `mm, t, s, N`; see the [`FromStr`] implementation for what is read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Units {
    length: (&'static str, f64),
    mass: (&'static str, f64),
    time: (&'static str, f64),
}

impl Units {
    /// m, kg, s, N.
    pub const SI: Self = Self { length: LENGTHS[0], mass: MASSES[0], time: TIMES[0] };

    /// The units that a text names, `None` for [`UNKNOWN_UNITS`] and for texts for people.
    pub fn of(text: &str) -> Option<Self> {
        text.parse().ok()
    }

    /// Name of the unit of length.
    pub fn length_name(&self) -> &'static str {
        self.length.0
    }

    /// Name of the unit of mass.
    pub fn mass_name(&self) -> &'static str {
        self.mass.0
    }

    /// Name of the unit of time.
    pub fn time_name(&self) -> &'static str {
        self.time.0
    }

    /// Name of the unit of force, such as `N`, or `t m/s^2` where it has none of its own.
    pub fn force_name(&self) -> String {
        let force = self.mass.1 * self.length.1 / (self.time.1 * self.time.1);
        match FORCES.iter().find(|(_, value)| (value / force - 1.0).abs() < SAME) {
            Some((name, _)) => (*name).to_owned(),
            None => format!("{} {}/{}^2", self.mass.0, self.length.0, self.time.0),
        }
    }

    /// The unit of length. Units: m.
    pub fn length(&self) -> f64 {
        self.length.1
    }

    /// The unit of mass. Units: kg.
    pub fn mass(&self) -> f64 {
        self.mass.1
    }

    /// The unit of time. Units: s.
    pub fn time(&self) -> f64 {
        self.time.1
    }
}

impl fmt::Display for Units {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, {}, {}, {}", self.length.0, self.mass.0, self.time.0, self.force_name())
    }
}

/// A text that names no coherent set of units.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "`{text}` names no units: {reason}; expected `SI`, or length, mass, time such as `mm,t,s` or `mm, t, s, N` \
     (m mm cm um km in ft; kg t g mg lb slug slinch; s ms us)"
)]
pub struct UnitsError {
    /// The text.
    pub text: String,
    /// What is wrong with it.
    pub reason: String,
}

impl FromStr for Units {
    type Err = UnitsError;

    /// Reads `SI`, or the units of length, mass and time with commas between, and that of force if it is there: it must
    /// be the one that follows from the others. A leading `SI:` is passed over.
    fn from_str(text: &str) -> Result<Self, UnitsError> {
        let error = |reason: String| UnitsError { text: text.to_owned(), reason };
        let names = text.trim();
        let names = names.strip_prefix("SI:").unwrap_or(names);
        if names.trim() == "SI" {
            return Ok(Self::SI);
        }
        let names: Vec<&str> = names.split(',').map(str::trim).collect();
        let (length, mass, time, force) = match names.as_slice() {
            &[length, mass, time] => (length, mass, time, None),
            &[length, mass, time, force] => (length, mass, time, Some(force)),
            other => return Err(error(format!("three or four names are needed, found {}", other.len()))),
        };
        let find = |what: &str, name: &str, table: Table| {
            let known = table.iter().find(|(known, _)| *known == name);
            known.copied().ok_or_else(|| error(format!("`{name}` is no unit of {what}")))
        };
        let units = Self {
            length: find("length", length, LENGTHS)?,
            mass: find("mass", mass, MASSES)?,
            time: find("time", time, TIMES)?,
        };
        match force {
            Some(force) if force != units.force_name() => Err(error(format!(
                "force in {length}, {mass}, {time} is in {}, not {force}",
                units.force_name()
            ))),
            _ => Ok(units),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_printed_is_read_and_the_force_follows() {
        for (text, printed) in [
            ("SI", "m, kg, s, N"),
            ("SI: m, kg, s, N", "m, kg, s, N"),
            ("mm,t,s", "mm, t, s, N"),
            ("mm, kg, ms", "mm, kg, ms, kN"),
            ("mm,kg,s", "mm, kg, s, mN"),
            ("in, slinch, s", "in, slinch, s, lbf"),
            ("ft,slug,s", "ft, slug, s, lbf"),
            ("cm, g, s", "cm, g, s, g cm/s^2"),
        ] {
            let units: Units = text.parse().unwrap();
            assert_eq!(units.to_string(), printed);
            assert_eq!(printed.parse(), Ok(units));
        }
        assert_eq!(Units::of(UNKNOWN_UNITS), None);
    }

    #[test]
    fn what_is_no_set_of_units_says_why() {
        for (text, reason) in [
            ("mm", "found 1"),
            ("kg, m, s", "`kg` is no unit of length"),
            ("mm,t,s,kN", "is in N, not kN"),
            ("mm, t, min", "`min` is no unit of time"),
        ] {
            let message = text.parse::<Units>().unwrap_err().to_string();
            assert!(message.contains(reason), "{message}");
        }
    }
}
