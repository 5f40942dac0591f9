//! Which modes each flexible body of a scene has in a configuration.

use std::collections::BTreeMap;
use std::fmt;
use std::str::FromStr;

use super::Modes;

/// Modes of the flexible bodies of a scene: one choice for all of them, or one for each.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum SceneModes {
    /// Of every flexible body, those of them that it has.
    Every(Modes),
    /// Of each flexible body by its name; of one that is not named, all that it has.
    Each(BTreeMap<String, Modes>),
}

impl SceneModes {
    /// The first so many of every body.
    pub fn first(count: usize) -> Self {
        Self::Every(Modes::first(count))
    }

    /// Those that a body of `available` modes has.
    pub fn of(&self, body: &str, available: usize) -> Modes {
        match self {
            Self::Every(modes) => modes.of(available),
            Self::Each(modes) => modes.get(body).map_or(Modes::first(available), |modes| modes.of(available)),
        }
    }

    /// Whether a body has a mode, of those that its model has.
    pub fn has(&self, body: &str, mode: usize) -> bool {
        match self {
            Self::Every(modes) => modes.has(mode),
            Self::Each(modes) => modes.get(body).is_none_or(|modes| modes.has(mode)),
        }
    }

    /// The most modes that one body has, of those that are named.
    pub fn most(&self) -> usize {
        match self {
            Self::Every(modes) => modes.count(),
            Self::Each(modes) => modes.values().map(Modes::count).max().unwrap_or(0),
        }
    }

    /// Whether no body that is named has any.
    pub fn is_rigid(&self) -> bool {
        self.most() == 0
    }

    /// A name fit for files.
    pub(super) fn key(&self) -> String {
        match self {
            Self::Every(modes) => modes.key(),
            Self::Each(modes) => modes
                .iter()
                .map(|(body, modes)| format!("{body}.{}", modes.key()))
                .collect::<Vec<_>>()
                .join("+"),
        }
    }

    /// The form that the same modes of these bodies have always: one choice for all where one says it, else every body named.
    pub(super) fn canonical(self, bodies: &[(&str, usize)]) -> Self {
        if matches!(self, Self::Every(_)) {
            return self;
        }
        let own = |(body, available): &(&str, usize)| ((*body).to_owned(), self.of(body, *available));
        let all: BTreeMap<String, Modes> = bodies.iter().map(own).collect();
        let says_it =
            |one: &&Modes| bodies.iter().all(|(body, available)| all.get(*body) == Some(&one.of(*available)));
        match all.values().find(says_it) {
            Some(one) => Self::Every(one.clone()),
            None => Self::Each(all),
        }
    }
}

impl From<Modes> for SceneModes {
    fn from(modes: Modes) -> Self {
        Self::Every(modes)
    }
}

impl From<usize> for SceneModes {
    fn from(count: usize) -> Self {
        Self::first(count)
    }
}

/// As [`Modes`], or `crank=4 rod=[0, 5]`.
impl fmt::Display for SceneModes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Every(modes) => modes.fmt(f),
            Self::Each(modes) => {
                let each: Vec<String> = modes.iter().map(|(body, modes)| format!("{body}={modes}")).collect();
                f.pad(&each.join(" "))
            }
        }
    }
}

/// The values of the axis of modes that are given at once: `0,2,[0+5]` for every body that is not named elsewhere, or
/// `rod=0,2,[0+5]` for one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ModeValues {
    /// The body; without one, all that are not named elsewhere.
    pub body: Option<String>,
    /// Its modes.
    pub modes: Vec<Modes>,
}

impl FromStr for ModeValues {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (body, list) = match text.split_once('=') {
            Some((body, list)) => (Some(body.trim()), list),
            None => (None, text),
        };
        if body.is_some_and(str::is_empty) {
            return Err(format!("`{text}`: expected the name of a body before `=`"));
        }
        let modes = outside_brackets(list).into_iter().map(str::parse).collect::<Result<_, _>>()?;
        Ok(Self { body: body.map(str::to_owned), modes })
    }
}

/// The parts of a list between the commas that stand outside brackets.
fn outside_brackets(list: &str) -> Vec<&str> {
    let mut is_inside = false;
    list.split(|c| {
        is_inside = c == '[' || is_inside && c != ']';
        c == ',' && !is_inside
    })
    .collect()
}

/// Every combination of the values for the flexible `bodies`, whose names and numbers of modes are given: those without a name
/// go for all bodies that are not named, all at once; without any such, these bodies have all their modes.
///
/// Errors: a name that no flexible body has; the message lists those that there are.
pub(super) fn combinations(
    values: &[ModeValues],
    bodies: &[(&str, usize)],
) -> Result<Vec<SceneModes>, String> {
    let mut common: Vec<Modes> = Vec::new();
    let mut named: BTreeMap<&str, Vec<Modes>> = BTreeMap::new();
    for ModeValues { body, modes } in values {
        match body {
            None => common.extend(modes.iter().cloned()),
            Some(name) => {
                check_names([name.as_str()], bodies)?;
                named.entry(name).or_default().extend(modes.iter().cloned());
            }
        }
    }
    if named.is_empty() {
        return Ok(common.into_iter().map(SceneModes::Every).collect());
    }
    let others: Vec<Option<&Modes>> =
        if common.is_empty() { vec![None] } else { common.iter().map(Some).collect() };
    let mut all: Vec<BTreeMap<String, Modes>> = others
        .into_iter()
        .map(|modes| {
            let rest = bodies.iter().filter(|(name, _)| !named.contains_key(name));
            rest.map(|(name, available)| {
                let own = modes.map_or(Modes::first(*available), |modes| modes.of(*available));
                ((*name).to_owned(), own)
            })
            .collect()
        })
        .collect();
    for (name, available) in bodies {
        let Some(values) = named.get(name) else { continue };
        let with = |before: &BTreeMap<String, Modes>, modes: &Modes| {
            let mut more = before.clone();
            more.insert((*name).to_owned(), modes.of(*available));
            more
        };
        all = all.iter().flat_map(|before| values.iter().map(move |modes| with(before, modes))).collect();
    }
    Ok(all.into_iter().map(|each| SceneModes::Each(each).canonical(bodies)).collect())
}

/// Errors: a name that no flexible body has; the message lists those that there are.
pub(super) fn check_names<'a>(
    names: impl IntoIterator<Item = &'a str>,
    bodies: &[(&str, usize)],
) -> Result<(), String> {
    for name in names {
        if !bodies.iter().any(|(body, _)| *body == name) {
            let known: Vec<String> = bodies.iter().map(|(body, _)| format!("`{body}`")).collect();
            let known = if known.is_empty() { "no body: all are rigid".to_owned() } else { known.join(", ") };
            return Err(format!("modes of `{name}`: expected a flexible body, {known}"));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const BODIES: [(&str, usize); 2] = [("rod", 8), ("crank", 4)];

    fn axis(values: &[&str]) -> Vec<String> {
        let values: Vec<ModeValues> = values.iter().map(|text| text.parse().unwrap()).collect();
        combinations(&values, &BODIES).unwrap().iter().map(SceneModes::to_string).collect()
    }

    #[test]
    fn values_without_a_name_are_for_all_bodies_and_named_ones_are_combined() {
        assert_eq!(axis(&["0,2,[0+5]", "8"]), ["0", "2", "[0, 5]", "8"]);
        assert_eq!(axis(&["rod=0,2", "crank=0,1"]), ["0", "crank=1 rod=0", "crank=0 rod=2", "crank=1 rod=2"]);
        // a body that is not named has all its modes, or what all others have
        assert_eq!(axis(&["rod=0,[0,5],8"]), ["crank=4 rod=0", "crank=4 rod=[0, 5]", "8"]);
        assert_eq!(
            axis(&["rod=1,3", "0,2"]),
            ["crank=0 rod=1", "crank=0 rod=3", "crank=2 rod=1", "crank=2 rod=3"]
        );
        let values = ["shaft=2".parse().unwrap()];
        let message = combinations(&values, &BODIES).unwrap_err();
        assert!(message.contains("`shaft`") && message.contains("`rod`, `crank`"), "{message}");
        for text in ["=2", "rod=", "rod=x", "rod=[0", ""] {
            assert!(text.parse::<ModeValues>().is_err(), "{text}");
        }
    }

    #[test]
    fn every_choice_has_one_form_and_one_name() {
        let each = |rod: usize, crank: usize| {
            let modes = [("rod", rod), ("crank", crank)];
            let modes = modes.map(|(body, count)| (body.to_owned(), Modes::first(count)));
            SceneModes::Each(modes.into()).canonical(&BODIES)
        };
        assert_eq!(each(3, 3), SceneModes::first(3));
        assert_eq!(each(9, 9), SceneModes::first(8));
        assert_eq!(each(2, 0).key(), "crank.m0+rod.m2");
        assert_eq!((each(2, 0).most(), each(0, 0).is_rigid()), (2, true));
        let two = each(2, 1);
        assert!(two.has("rod", 1) && !two.has("crank", 1) && two.has("another", 7));
        assert_eq!(two.of("crank", 4), Modes::first(1));
    }
}
