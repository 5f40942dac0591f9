//! Why a scene cannot be read or composed.

use std::path::PathBuf;

use ffrf_codegen::mechanism::TopologyError;
use ffrf_model::ModelError;
use thiserror::Error;

/// What is wrong with a scene, with the key where it stands.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum SceneError {
    /// The file cannot be read.
    #[error("{}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// The file is not TOML; the message has line and column.
    #[error("{0}")]
    Syntax(#[from] Box<toml::de::Error>),
    /// What is wrong on a line.
    #[error("line {line}: {error}")]
    Line {
        /// The line, counted from one.
        line: usize,
        /// What is wrong.
        error: Box<SceneError>,
    },
    /// A table has a key that is unknown, missing, or of another kind.
    #[error("{key}: {message}")]
    Key {
        /// Path of the table, as in `bodies.rod`.
        key: String,
        /// What is expected and what was found.
        message: String,
    },
    /// A value that cannot be.
    #[error("{key}: expected {expected}, found {found}")]
    Value {
        /// Path of the value.
        key: String,
        /// What is expected.
        expected: String,
        /// What was found.
        found: String,
    },
    /// A name that nothing has.
    #[error("{key}: no {kind} is called `{found}`; there are {known}")]
    Unknown {
        /// Path of the value.
        key: String,
        /// What kind of thing is named.
        kind: &'static str,
        /// The name found.
        found: String,
        /// The names that exist.
        known: String,
    },
    /// A model file is refused.
    #[error("{key}: {path}: {source}", path = path.display())]
    Model {
        /// Path of the value.
        key: String,
        /// The file.
        path: PathBuf,
        /// Why.
        source: Box<ModelError>,
    },
    /// Joints that cannot be.
    #[error("joints: {0}")]
    Topology(#[from] TopologyError),
    /// No initial velocities or accelerations meet the joints: they, or their drives, contradict each other.
    #[error(
        "joint `{joint}`: no initial {level} meet it, {residual:.3e} {unit} is left: joints or drives contradict each other"
    )]
    Contradiction {
        /// The joint.
        joint: String,
        /// `velocities` or `accelerations`.
        level: &'static str,
        /// What is left.
        residual: f64,
        /// Its unit.
        unit: &'static str,
    },
    /// The initial state does not meet the joints and cannot be made to.
    #[error(
        "joint `{joint}`: the initial state misses it by {residual:.3e} (m or rad), and no correction closes it"
    )]
    NotAssembled {
        /// The joint.
        joint: String,
        /// What is left.
        residual: f64,
    },
}

impl SceneError {
    /// The key that is at fault, if one is.
    fn key(&self) -> Option<&str> {
        match self {
            Self::Key { key, .. }
            | Self::Value { key, .. }
            | Self::Unknown { key, .. }
            | Self::Model { key, .. } => Some(key),
            _ => None,
        }
    }

    /// The same with the line of its key.
    pub(super) fn on_line(self, lines: &super::Lines) -> Self {
        match self.key().and_then(|key| lines.of_key(key)) {
            Some(line) => Self::Line { line, error: Box::new(self) },
            None => self,
        }
    }

    /// [`SceneError::Value`] in short.
    pub(super) fn value(key: impl Into<String>, expected: impl Into<String>, found: impl ToString) -> Self {
        Self::Value { key: key.into(), expected: expected.into(), found: found.to_string() }
    }
}
