//! The frames of an animation, from the columns of a simulation.

use anyhow::{Result, bail};
use ffrf_host::scene::Scene;

use super::Show;
use crate::results::Columns;

/// Most frames: a minute at fifty frames a second.
const MOST: usize = 3000;
/// Shortest and longest time that an animation plays unless told otherwise. Units: s.
const PLAYBACK: [f64; 2] = [2.0, 60.0];

/// Where all bodies are, frame by frame.
pub(super) struct Frames {
    /// Times of playback. Units: s.
    pub(super) times: Vec<f32>,
    /// Simulated time from the first to the last frame. Units: s.
    pub(super) motion: f64,
    /// The motion of each body.
    pub(super) bodies: Vec<BodyFrames>,
}

/// Where one body is, frame by frame.
pub(super) struct BodyFrames {
    pub(super) positions: Vec<[f32; 3]>,
    /// Vector part first, as glTF has it.
    pub(super) orientations: Vec<[f32; 4]>,
    /// Modal coordinates, all of one frame together.
    pub(super) weights: Vec<f32>,
}

impl Frames {
    pub(super) fn new(scene: &Scene, columns: &Columns, show: Show) -> Result<Self> {
        let (Some(first), Some(last)) = (columns.rows.first(), columns.rows.last()) else {
            bail!("there is nothing to animate");
        };
        let (start, motion) = (first[0], last[0] - first[0]);
        if motion.is_nan() || motion <= 0.0 {
            bail!("there is nothing to animate: the motion takes {motion} s");
        }
        let playback = show.playback.unwrap_or_else(|| motion.clamp(PLAYBACK[0], PLAYBACK[1]));
        let stride = columns.rows.len().div_ceil(MOST).max(1);
        let rows: Vec<&Vec<f64>> = columns.rows.iter().step_by(stride).collect();
        // in each row: the time, then for each body position, orientation, modes, velocity, angular velocity, rates of modes
        let mut place = 1;
        let bodies = scene.mechanism.bodies().iter().map(|body| {
            let modes = body.mode_count();
            let frames = BodyFrames::new(&rows, place, modes);
            place += 13 + 2 * modes;
            frames
        });
        Ok(Self {
            bodies: bodies.collect(),
            times: rows.iter().map(|row| ((row[0] - start) * playback / motion) as f32).collect(),
            motion,
        })
    }
}

impl BodyFrames {
    fn new(rows: &[&Vec<f64>], place: usize, modes: usize) -> Self {
        let number = |row: &Vec<f64>, offset: usize| row.get(place + offset).copied().unwrap_or(0.0) as f32;
        let mut before = [0.0_f32; 4];
        let turned = |row: &&Vec<f64>| {
            let mut next = [number(row, 4), number(row, 5), number(row, 6), number(row, 3)];
            // q and -q are one orientation; the way between frames must be the short one
            if before.iter().zip(next).map(|(a, b)| a * b).sum::<f32>() < 0.0 {
                next = next.map(|x| -x);
            }
            before = next;
            next
        };
        Self {
            positions: rows.iter().map(|row| [0, 1, 2].map(|axis| number(row, axis))).collect(),
            orientations: rows.iter().map(turned).collect(),
            weights: rows
                .iter()
                .flat_map(|row| (0..modes).map(|mode| number(row, 7 + mode)).collect::<Vec<_>>())
                .collect(),
        }
    }
}
