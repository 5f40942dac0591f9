//! Names of bodies and markers, and where they stand.

use ffrf_runtime::mechanism::Attachment;
use ffrf_runtime::{FlexibleBody, Marker, SectionMarker, StressMarker};
use nalgebra::{UnitQuaternion, Vector3};

use super::file::Vector;
use super::{SceneError, SceneModel};
use crate::{HostBody, HostModal};

/// A body of the scene while it is composed: markers can be added.
#[derive(Debug, Clone)]
pub(super) struct NamedBody {
    pub(super) name: String,
    pub(super) body: HostBody,
    /// What it was read from.
    pub(super) model: Option<SceneModel>,
    pub(super) marker_names: Vec<String>,
    /// The named ones first, then those that joints and sensors ask for.
    pub(super) markers: Vec<Marker<HostModal, f64>>,
    /// Stress markers of the model, by name.
    pub(super) stress_markers: Vec<(String, StressMarker<HostModal, f64>)>,
    /// Section markers of the model, by name.
    pub(super) section_markers: Vec<(String, SectionMarker<HostModal, f64>)>,
}

impl NamedBody {
    /// A marker on the rigid part of the body, made on demand.
    fn rigid_marker(&mut self, position: Vector3<f64>) -> usize {
        self.markers.push(Marker::rigid(position, &self.body.undeformed()));
        self.markers.len() - 1
    }
}

/// The attachment called `name`: `ground`, BODY or BODY.MARKER, moved by `position` in its frame.
pub(super) fn attachment(
    bodies: &mut [NamedBody],
    key: &str,
    name: &str,
    position: Option<Vector>,
) -> Result<Attachment<f64>, SceneError> {
    let offset = position.map_or_else(Vector3::zeros, Vector3::from);
    let orientation = UnitQuaternion::identity();
    if name == "ground" {
        return Ok(Attachment { body: None, marker: 0, position: offset, orientation });
    }
    let (body_name, marker_name) = match name.split_once('.') {
        Some((body, marker)) => (body, Some(marker)),
        None => (name, None),
    };
    let known = || {
        let names: Vec<&str> = bodies.iter().map(|body| body.name.as_str()).collect();
        format!("ground, {}", names.join(", "))
    };
    let Some(index) = bodies.iter().position(|body| body.name == body_name) else {
        return Err(SceneError::Unknown {
            key: key.to_owned(),
            kind: "body",
            found: body_name.to_owned(),
            known: known(),
        });
    };
    let body = &mut bodies[index];
    let marker = match marker_name {
        None => body.rigid_marker(offset),
        Some(marker) => {
            let Some(found) = body.marker_names.iter().position(|name| name == marker) else {
                return Err(SceneError::Unknown {
                    key: key.to_owned(),
                    kind: "marker",
                    found: name.to_owned(),
                    known: if body.marker_names.is_empty() {
                        "none".to_owned()
                    } else {
                        body.marker_names.join(", ")
                    },
                });
            };
            if offset == Vector3::zeros() {
                found
            } else {
                // a point that is rigidly fixed to the material at the marker, to first order in its rotation
                let base = body.markers[found].clone();
                let mut moved = base.clone();
                moved.position += offset;
                for axis in 0..3 {
                    let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
                    // rotation × offset
                    moved.translation[axis].0 +=
                        &base.rotation[next].0 * offset[last] - &base.rotation[last].0 * offset[next];
                }
                body.markers.push(moved);
                body.markers.len() - 1
            }
        }
    };
    Ok(Attachment { body: Some(index), marker, position: Vector3::zeros(), orientation })
}

/// The marker of a `kind` of its own that is called `name`, BODY.MARKER, and the number of its body.
pub(super) fn named_in_a_body<M: Clone>(
    bodies: &[NamedBody],
    key: &str,
    kind: &'static str,
    name: &str,
    markers: impl Fn(&NamedBody) -> &[(String, M)],
) -> Result<(usize, M), SceneError> {
    let mut known = Vec::new();
    for (index, body) in bodies.iter().enumerate() {
        for (marker, found) in markers(body) {
            let full = format!("{}.{marker}", body.name);
            if full == name {
                return Ok((index, found.clone()));
            }
            known.push(full);
        }
    }
    Err(SceneError::Unknown {
        key: key.to_owned(),
        kind,
        found: name.escape_debug().to_string(),
        known: if known.is_empty() { "none".to_owned() } else { known.join(", ") },
    })
}

/// Errors: both ends are on one body, or on the ground.
pub(super) fn different(
    key: &str,
    bodies: &[NamedBody],
    [first, second]: [&Attachment<f64>; 2],
) -> Result<(), SceneError> {
    if first.body != second.body {
        return Ok(());
    }
    let found = first.body.map_or("ground", |body| bodies[body].name.as_str());
    Err(SceneError::value(key, "two different ends", format!("`{found}` at both")))
}
