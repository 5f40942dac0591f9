//! A simulation as one animated model in glTF's binary form (`.glb`), for browsers, Blender and other viewers.
//!
//! Bodies are nodes that move and turn. Flexible ones carry their modes as morph targets, weighted by the modal coordinates: a
//! frame costs seven numbers and one for each mode, however fine the surface.

mod document;
mod frames;
mod skin;
mod surface;

use anyhow::Result;
use ffrf_host::picture::{Shape, skeletons};
use ffrf_host::scene::Scene;

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

/// The bytes of a `.glb` file, and a line about it. `surfaces`: of each body, where there is one.
pub fn glb(
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
    let line = format!(
        "{} frames, {:.3} s of motion in {:.3} s{}",
        frames.times.len(),
        frames.motion,
        frames.times.last().copied().unwrap_or(0.0),
        if show.deformation == 1.0 {
            String::new()
        } else {
            format!(", deformation drawn {} times too large", show.deformation)
        }
    );
    Ok((document::write(scene, &shapes, &frames, show.deformation), line))
}
