//! From one coherent set of units to another.

use faer::Mat;
use ffrf_model::Units;

use crate::{Elasticity, FeModel};

/// Factors from the units of the files to those wanted.
///
/// Modal coordinates keep their meaning, so that mode shapes scale as lengths. Time enters through the stiffness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Conversion {
    /// Unit of length of the files over that wanted.
    length: f64,
    /// The same for mass.
    mass: f64,
    /// The same for time.
    time: f64,
}

impl Conversion {
    /// The conversion from some units to others.
    pub fn new(from: &Units, to: &Units) -> Self {
        Self {
            length: from.length() / to.length(),
            mass: from.mass() / to.mass(),
            time: from.time() / to.time(),
        }
    }

    /// Converts positions, mass, stiffness and materials.
    pub fn model(&self, model: &mut FeModel) {
        for coordinate in model.nodes.positions.iter_mut().flatten() {
            *coordinate *= self.length;
        }
        model.mass.val_mut().iter_mut().for_each(|value| *value *= self.mass);
        let stiffness = self.mass / (self.time * self.time);
        if let Some(matrix) = &mut model.stiffness {
            matrix.val_mut().iter_mut().for_each(|value| *value *= stiffness);
        }
        for elasticity in model.materials.iter_mut().filter_map(|material| material.elasticity.as_mut()) {
            *elasticity = self.elasticity(*elasticity);
        }
    }

    /// Converts elastic constants.
    pub fn elasticity(&self, mut elasticity: Elasticity) -> Elasticity {
        elasticity.youngs_modulus *= self.mass / (self.length * self.time * self.time);
        elasticity
    }

    /// Converts mode shapes.
    pub fn shapes(&self, shapes: &mut Mat<f64>) {
        scale(shapes, self.length);
    }

    /// Converts a modal stiffness K_ff: energy over the square of modal coordinates.
    pub fn modal_stiffness(&self, stiffness: &mut Mat<f64>) {
        let speed = self.length / self.time;
        scale(stiffness, self.mass * speed * speed);
    }
}

fn scale(matrix: &mut Mat<f64>, factor: f64) {
    for column in 0..matrix.ncols() {
        matrix.col_as_slice_mut(column).iter_mut().for_each(|value| *value *= factor);
    }
}
