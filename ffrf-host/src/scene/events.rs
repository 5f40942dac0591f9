//! Events of a scene: where a sensor passes a value.

use super::SceneError;
use super::file::EventTable;
use super::sensors::{Sensor, SensorKind};

/// An event of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneEvent {
    /// Its name.
    pub name: String,
    /// What is watched.
    pub kind: SensorKind,
    /// Which of the sensor's numbers.
    pub component: usize,
    /// The value that is passed. Units: those of the sensor.
    pub value: f64,
    /// Which ways of passing count.
    pub direction: Direction,
    /// Whether the run ends there.
    pub stops: bool,
}

/// Which way a value is passed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// From below.
    Rising,
    /// From above.
    Falling,
    /// Both.
    Either,
}

impl Direction {
    /// Whether passing counts.
    pub fn counts(self, rising: bool) -> bool {
        match self {
            Self::Rising => rising,
            Self::Falling => !rising,
            Self::Either => true,
        }
    }
}

/// The event of a table.
pub(super) fn event(name: &str, table: &EventTable, sensors: &[Sensor]) -> Result<SceneEvent, SceneError> {
    let key = |what: &str| format!("events.{name}.{what}");
    let Some(sensor) = sensors.iter().find(|sensor| sensor.name == table.sensor) else {
        return Err(SceneError::Unknown {
            key: key("sensor"),
            kind: "sensor",
            found: table.sensor.escape_debug().to_string(),
            known: sensors.iter().map(|sensor| sensor.name.as_str()).collect::<Vec<_>>().join(", "),
        });
    };
    let columns = sensor.kind.columns();
    let known = || columns.iter().map(|column| column.trim_start_matches('.')).collect::<Vec<_>>().join(", ");
    let component = match (&table.component, columns) {
        (None, [_]) => 0,
        (Some(found), [_]) => {
            let expected = format!("nothing: `{}` is one number", sensor.name);
            return Err(SceneError::value(key("component"), expected, format!("`{}`", found.escape_debug())));
        }
        (None, _) => {
            return Err(SceneError::value(key("component"), format!("one of {}", known()), "nothing"));
        }
        (Some(found), _) => {
            let place = columns.iter().position(|column| column.trim_start_matches('.') == found);
            place.ok_or_else(|| {
                let found = format!("`{}`", found.escape_debug());
                SceneError::value(key("component"), format!("one of {}", known()), found)
            })?
        }
    };
    if !table.value.is_finite() {
        return Err(SceneError::value(key("value"), "a finite number", table.value));
    }
    let word = |what: &str, found: &Option<String>, known: &[&str]| match found {
        None => Ok(0),
        Some(found) => known.iter().position(|word| word == found).ok_or_else(|| {
            let found = format!("`{}`", found.escape_debug());
            SceneError::value(key(what), format!("one of {}", known.join(", ")), found)
        }),
    };
    let direction = match word("direction", &table.direction, &["either", "rising", "falling"])? {
        1 => Direction::Rising,
        2 => Direction::Falling,
        _ => Direction::Either,
    };
    let stops = word("then", &table.then, &["record", "stop"])? == 1;
    Ok(SceneEvent {
        name: name.to_owned(),
        kind: sensor.kind.clone(),
        component,
        value: table.value,
        direction,
        stops,
    })
}
