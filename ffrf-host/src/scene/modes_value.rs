//! Which modes of its model a body of a scene uses.

use std::fmt;

use ffrf_model::ModeSelection;
use serde::de::value::SeqAccessDeserializer;
use serde::de::{Error, SeqAccess, Unexpected, Visitor};
use serde::{Deserialize, Deserializer};

/// `4` for the first four, `[0, 5]` for these, counted from 0.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ModesValue(pub ModeSelection);

impl ModesValue {
    /// Whether there are none.
    pub fn is_rigid(&self) -> bool {
        match &self.0 {
            ModeSelection::First(count) => *count == 0,
            ModeSelection::Listed(modes) => modes.is_empty(),
            _ => false,
        }
    }
}

impl<'de> Deserialize<'de> for ModesValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Form)
    }
}

struct Form;

impl<'de> Visitor<'de> for Form {
    type Value = ModesValue;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number of modes, or a list of modes from 0")
    }

    fn visit_i64<E: Error>(self, count: i64) -> Result<ModesValue, E> {
        let wrong = |_| E::invalid_value(Unexpected::Signed(count), &self);
        usize::try_from(count).map_err(wrong).map(|count| ModesValue(ModeSelection::First(count)))
    }

    fn visit_u64<E: Error>(self, count: u64) -> Result<ModesValue, E> {
        let wrong = |_| E::invalid_value(Unexpected::Unsigned(count), &self);
        usize::try_from(count).map_err(wrong).map(|count| ModesValue(ModeSelection::First(count)))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<ModesValue, A::Error> {
        let modes = Vec::deserialize(SeqAccessDeserializer::new(list))?;
        Ok(ModesValue(ModeSelection::Listed(modes)))
    }
}
