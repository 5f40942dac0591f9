//! A simulation as one animated model in glTF's binary form (`.glb`), for browsers, Blender and other viewers.
//!
//! Bodies are nodes that move and turn. Flexible ones carry their modes as morph targets, weighted by the modal coordinates: a
//! frame costs seven numbers and one for each mode, however fine the surface.

mod document;
mod frames;
mod skin;
mod surface;

use anyhow::Result;
use document::{Document, Part};
use ffrf_host::picture::{Shape, model_points, named_points, skeletons};
use ffrf_host::scene::Scene;
use ffrf_model::{Mode, ModeKind, ReducedBody};

use crate::results::Columns;

pub use skin::skin;
pub use surface::Surface;

/// How a simulation is shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Show {
    /// How long the animation plays; if nothing is said, as long as the motion, but at least 2 s and at most 60 s.
    pub playback: Option<f64>,
    /// Factor of the drawn deformation.
    pub deformation: f64,
}

/// The bytes of a `.glb` file of a motion, and a line about it. `surfaces`: of each body, where there is one.
pub fn glb(
    title: &str,
    scene: &Scene,
    columns: &Columns,
    surfaces: &[Option<Surface>],
    show: Show,
) -> Result<(Vec<u8>, String)> {
    let frames = frames::Frames::new(scene, columns, show)?;
    let shapes: Vec<Shape> = skeletons(scene)
        .into_iter()
        .zip(surfaces)
        .map(|(skeleton, surface)| surface.as_ref().map_or(skeleton, |surface| surface.0.clone()))
        .collect();
    let points = named_points(scene);
    let parts = shapes.iter().zip(&frames.bodies).zip(&points).enumerate().map(
        |(body, ((shape, motion), markers))| Part {
            name: scene.body_names.get(body).map_or("", String::as_str),
            shape,
            mode_names: (1..=shape.modes.len()).map(|mode| format!("mode {mode}")).collect(),
            markers,
            motion: Some(motion),
        },
    );
    let playback = f64::from(frames.times.last().copied().unwrap_or(0.0));
    let gravity = scene.mechanism.gravity();
    let document = Document {
        title,
        parts: parts.collect(),
        times: &frames.times,
        pace: frames.motion / playback,
        // up is against gravity, else z
        y_is_up: gravity.y.abs() > gravity.z.abs(),
        deformation: show.deformation,
    };
    let line = format!(
        "{} frames, {:.3} s of motion in {playback:.3} s{}",
        frames.times.len(),
        frames.motion,
        if show.deformation == 1.0 {
            String::new()
        } else {
            format!(", deformation drawn {} times too large", show.deformation)
        }
    );
    Ok((document.bytes(), line))
}

/// The bytes of a `.glb` file of one body at rest, with its modes and markers.
pub fn body_glb(body: &ReducedBody, shape: &Shape) -> Vec<u8> {
    let part = Part {
        name: &body.title,
        shape,
        mode_names: body.modes.iter().zip(1..).map(|(mode, number)| mode_name(mode, number)).collect(),
        markers: &model_points(body),
        motion: None,
    };
    let parts = vec![part];
    Document { title: &body.title, parts, times: &[], pace: 1.0, y_is_up: false, deformation: 1.0 }.bytes()
}

/// What a mode is called: its number, frequency, and how it was made where that is more than an eigenmode.
pub fn mode_name(mode: &Mode, number: usize) -> String {
    let kind = match mode.kind {
        ModeKind::Constraint => ", constraint mode",
        ModeKind::Attachment => ", attachment mode",
        ModeKind::User => ", user's shape",
        _ => "",
    };
    let frequency = mode.frequency_hz.map(|frequency| format!(": {frequency:.1} Hz")).unwrap_or_default();
    format!("mode {number}{frequency}{kind}")
}
