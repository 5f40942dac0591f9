//! Using some of the modes that a body has.

use std::fmt;
use std::str::FromStr;

use crate::{ModelError, ReducedBody, SecondOrderTerms};

/// Which modes of a body to use, counted from 0 as the modal coordinates are.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum ModeSelection {
    /// The first so many: `..8`.
    First(usize),
    /// From the first number to below the second: `2..5`.
    Range(usize, usize),
    /// These, in this order: `[0, 2, 5]`.
    Listed(Vec<usize>),
}

impl ModeSelection {
    /// The indices of the modes.
    ///
    /// Errors: `TooFewModes`, `NoSuchMode`, `RepeatedMode`.
    pub fn indices(&self, available: usize) -> Result<Vec<usize>, ModelError> {
        let listed = match self {
            Self::First(count) if *count > available => {
                return Err(ModelError::TooFewModes { requested: *count, available });
            }
            Self::First(count) => return Ok((0..*count).collect()),
            // The end first: a range may be far longer than any list.
            Self::Range(_, end) if *end > available => {
                return Err(ModelError::NoSuchMode { index: end - 1, available });
            }
            Self::Range(start, end) => (*start..*end).collect(),
            Self::Listed(indices) => indices.clone(),
        };
        let mut used = vec![false; available];
        for &index in &listed {
            match used.get_mut(index) {
                None => return Err(ModelError::NoSuchMode { index, available }),
                Some(true) => return Err(ModelError::RepeatedMode { index }),
                Some(place) => *place = true,
            }
        }
        Ok(listed)
    }
}

impl From<usize> for ModeSelection {
    fn from(count: usize) -> Self {
        Self::First(count)
    }
}

/// As the macro takes it.
impl fmt::Display for ModeSelection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::First(count) => write!(f, "..{count}"),
            Self::Range(start, end) => write!(f, "{start}..{end}"),
            Self::Listed(indices) => write!(f, "{indices:?}"),
        }
    }
}

/// What a mode selection may look like.
const FORMS: &str =
    "expected `8` or `..8` for the first 8 modes, `2..5` for a range, `[0, 2, 5]` for a list (from 0)";

/// The forms of the macro, `8` for `..8`, and a list without brackets if it has a comma.
impl FromStr for ModeSelection {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |part: &str| part.trim().parse::<usize>().map_err(|_| format!("`{text}`: {FORMS}"));
        if let Some((start, end)) = text.split_once("..") {
            if start.trim().is_empty() {
                return Ok(Self::First(number(end)?));
            }
            return match (number(start)?, number(end)?) {
                (start, end) if start < end => Ok(Self::Range(start, end)),
                _ => Err(format!("`{text}` has no modes")),
            };
        }
        let inner = text.trim().strip_prefix('[').and_then(|rest| rest.strip_suffix(']'));
        match inner {
            None if !text.contains(',') => Ok(Self::First(number(text)?)),
            Some("") => Ok(Self::Listed(Vec::new())),
            inner => inner.unwrap_or(text).split(',').map(number).collect::<Result<_, _>>().map(Self::Listed),
        }
    }
}

impl ReducedBody {
    /// The body with its first `count` modes only; see [`with_selected_modes`](Self::with_selected_modes).
    ///
    /// Errors: [`ModelError::TooFewModes`]; `Length` if the body's lists do not fit together.
    pub fn with_modes(&self, count: usize) -> Result<Self, ModelError> {
        self.with_selected_modes(&ModeSelection::First(count))
    }

    /// The body with the selected modes only, in the order of the selection.
    ///
    /// What it loses is the motion in the other modes; the numbers that stay are the same bits.
    ///
    /// Errors: those of [`ModeSelection::indices`]; `Length` if the body's lists do not fit together.
    pub fn with_selected_modes(&self, selection: &ModeSelection) -> Result<Self, ModelError> {
        self.check_shape()?;
        let indices = selection.indices(self.mode_count())?;
        let mut body = self.clone();
        body.modes = pick(&self.modes, &indices);
        if indices.is_empty() {
            // a body without modes has no such terms, so that it lacks none
            body.second_order_terms = SecondOrderTerms::Known;
        }
        body.inertia.modal_first_moment = pick(&self.inertia.modal_first_moment, &indices);
        body.inertia.position_mode_moment = pick(&self.inertia.position_mode_moment, &indices);
        body.inertia.mode_mode_moment = pick_square(&self.inertia.mode_mode_moment, &indices);
        body.stiffness = pick_square(&self.stiffness, &indices);
        body.damping = pick_square(&self.damping, &indices);
        if let Some(geometric) = &mut body.geometric_stiffness {
            geometric.uniform_load = pick_square(&geometric.uniform_load, &indices);
            geometric.linear_load = pick_square(&geometric.linear_load, &indices);
            for load in &mut geometric.marker_loads {
                load.stiffness = pick_square(&load.stiffness, &indices);
            }
        }
        for (marker, whole) in body.markers.iter_mut().zip(&self.markers) {
            marker.translation = pick(&whole.translation, &indices);
            marker.rotation = pick(&whole.rotation, &indices);
        }
        for (marker, whole) in body.stress_markers.iter_mut().zip(&self.stress_markers) {
            marker.stress = pick(&whole.stress, &indices);
        }
        for (marker, whole) in body.section_markers.iter_mut().zip(&self.section_markers) {
            marker.force = pick(&whole.force, &indices);
        }
        Ok(body)
    }
}

fn pick<T: Clone>(list: &[T], indices: &[usize]) -> Vec<T> {
    indices.iter().filter_map(|&index| list.get(index).cloned()).collect()
}

fn pick_square<T: Clone>(matrix: &[Vec<T>], indices: &[usize]) -> Vec<Vec<T>> {
    pick(matrix, indices).iter().map(|row| pick(row, indices)).collect()
}
