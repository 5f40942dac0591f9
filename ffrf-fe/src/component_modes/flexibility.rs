//! Flexibility of the part: displacements of forces, from one factor of the stiffness on as few supports as stop
//! rigid motion.

use faer::sparse::SparseColMat;
use faer::{Mat, MatRef, Par};

use crate::modes::{Analysis, Factor, ModeError, node_order, product};

use super::coordinates::Coordinates;
use super::rigid_motion::RigidMotion;

/// The lower triangle of the supported stiffness.
pub(crate) type SupportedStiffness = SparseColMat<u32, f64>;

/// The pattern of the supported stiffness.
pub(crate) struct Supported {
    /// Number of each coordinate among those that are not held.
    number: Vec<Option<u32>>,
    /// How many are not held.
    count: usize,
    pub analysis: Analysis,
}

impl Supported {
    /// The pattern, and the stiffness itself, which is not needed longer than until it is factored.
    ///
    /// Errors: [`ModeError::FactorTooLarge`].
    pub fn new(
        coordinates: &Coordinates<'_>,
        rigid: &RigidMotion,
    ) -> Result<(Self, SupportedStiffness), ModeError> {
        let supports = rigid.supports(coordinates);
        let mut count = 0;
        let number: Vec<Option<u32>> = (0..coordinates.dimension())
            .map(|place| {
                let kept = supports.binary_search(&place).is_err();
                count += u32::from(kept);
                kept.then(|| count - 1)
            })
            .collect();
        let (lower, node_of) = coordinates.shifted_lower(0.0, &number);
        let order = node_order(&lower, &node_of, &coordinates.node_positions())?.order;
        let analysis = Analysis::new(&lower, &order)?;
        Ok((Self { number, count: lower.nrows(), analysis }, lower))
    }
}

/// Displacements of forces.
pub(crate) struct Flexibility<'a> {
    pub coordinates: &'a Coordinates<'a>,
    pub rigid: &'a RigidMotion,
    supported: &'a Supported,
    factor: Factor<'a>,
    pub threads: usize,
}

impl<'a> Flexibility<'a> {
    /// Factors the supported stiffness.
    ///
    /// Errors: [`ModeError::NotPositiveDefinite`] for a part that is not whole or a stiffness that is none.
    pub fn new(
        coordinates: &'a Coordinates<'a>,
        rigid: &'a RigidMotion,
        supported: &'a Supported,
        stiffness: SupportedStiffness,
        threads: usize,
    ) -> Result<Self, ModeError> {
        let factor = supported.analysis.factorise(&stiffness)?;
        Ok(Self { coordinates, rigid, supported, factor, threads })
    }

    /// G F: displacements with the supports at rest. The supports take what the forces do not balance.
    pub fn supported(&self, forces: MatRef<'_, f64>) -> Mat<f64> {
        let number = &self.supported.number;
        let mut reduced = Mat::zeros(self.supported.count, forces.ncols());
        for j in 0..forces.ncols() {
            let column = reduced.col_as_slice_mut(j);
            for (place, number) in number.iter().enumerate() {
                if let Some(number) = number {
                    column[*number as usize] = forces[(place, j)];
                }
            }
        }
        self.factor.solve_in_place(reduced.as_mut(), self.threads);
        let mut shapes = Mat::zeros(number.len(), forces.ncols());
        for j in 0..forces.ncols() {
            let column = shapes.col_as_slice_mut(j);
            for (place, number) in number.iter().enumerate() {
                if let Some(number) = number {
                    column[place] = reduced[(*number as usize, j)];
                }
            }
        }
        shapes
    }

    /// Elastic displacements in mean axes of forces balanced by the inertia of the rigid acceleration they cause
    /// (inertia relief).
    pub fn elastic(&self, mut forces: Mat<f64>) -> Mat<f64> {
        self.rigid.balance(&mut forces);
        let mut shapes = self.supported(forces.as_ref());
        self.rigid.remove_from(&mut shapes);
        shapes
    }

    /// [`Self::elastic`] with one step of refinement, for the few shapes that enter a basis.
    pub fn elastic_refined(&self, mut forces: Mat<f64>) -> Mat<f64> {
        self.rigid.balance(&mut forces);
        let shapes = self.elastic(forces.clone());
        let rest = forces - self.coordinates.stiffness_times(shapes.as_ref());
        shapes + self.elastic(rest)
    }

    /// R a.
    pub fn rigid_shapes(&self, amounts: MatRef<'_, f64>) -> Mat<f64> {
        product(self.rigid.shapes.as_ref(), amounts, Par::Seq)
    }
}
