//! Motion of the interfaces: six rows B for each, with q = B y.

use faer::{Mat, MatRef};

use super::coordinates::Coordinates;
use super::coupling_rbe3::averaging_rows;
use super::{ComponentModeError, Coupling, Interface};

/// The rows that read the motion of every interface off a shape.
///
/// Row 6 k + i is motion i of interface k: translations along x, y, z (m), then rotations about them (rad).
pub(crate) struct InterfaceMotion {
    sources: Vec<Source>,
}

enum Source {
    /// Coordinates from this place on.
    Coordinates(usize),
    /// Rows of nodes with their 6 x 3 blocks.
    Mean(Vec<(usize, [[f64; 3]; 6])>),
}

impl InterfaceMotion {
    /// Errors: [`ComponentModeError::Collinear`].
    pub fn new(coordinates: &Coordinates<'_>, interfaces: &[Interface]) -> Result<Self, ComponentModeError> {
        let mut places = coordinates.rigid_places();
        let positions = &coordinates.model.nodes.positions;
        let sources = interfaces.iter().map(|interface| {
            let collinear = || ComponentModeError::Collinear {
                interface: interface.name.clone(),
                nodes: interface.nodes.len(),
                spread: 0.0,
                least: 0.0,
            };
            match &interface.coupling {
                Coupling::Rigid => places.next().map(Source::Coordinates).ok_or_else(collinear),
                Coupling::Average { weights } => {
                    let here: Vec<_> = interface.nodes.iter().map(|&row| positions[row]).collect();
                    let rows =
                        averaging_rows(&here, weights, interface.reference_point).ok_or_else(collinear)?;
                    Ok(Source::Mean(interface.nodes.iter().copied().zip(rows).collect()))
                }
            }
        });
        Ok(Self { sources: sources.collect::<Result<_, _>>()? })
    }

    /// The rows of the first interface.
    pub fn first(mut self) -> Self {
        self.sources.truncate(1);
        self
    }

    /// Number of rows.
    pub fn count(&self) -> usize {
        6 * self.sources.len()
    }

    /// B Y, for shapes in coordinates y.
    pub fn of(&self, coordinates: &Coordinates<'_>, shapes: MatRef<'_, f64>) -> Mat<f64> {
        let full = if self.sources.iter().any(|source| matches!(source, Source::Mean(_))) {
            coordinates.expand(shapes)
        } else {
            Mat::zeros(0, shapes.ncols())
        };
        let mut motion = Mat::zeros(self.count(), shapes.ncols());
        for (number, source) in self.sources.iter().enumerate() {
            for j in 0..shapes.ncols() {
                for k in 0..6 {
                    motion[(6 * number + k, j)] = match source {
                        Source::Coordinates(first) => shapes[(first + k, j)],
                        Source::Mean(rows) => rows
                            .iter()
                            .map(|(node, block)| {
                                (0..3).map(|i| block[k][i] * full[(3 * node + i, j)]).sum::<f64>()
                            })
                            .sum(),
                    };
                }
            }
        }
        motion
    }

    /// Bᵀ: forces on y of a unit force or moment at each interface motion. Shape: n x rows.
    pub fn forces(&self, coordinates: &Coordinates<'_>) -> Mat<f64> {
        let mut direct = Mat::zeros(coordinates.dimension(), self.count());
        let mut full = Mat::zeros(3 * coordinates.model.nodes.len(), self.count());
        for (number, source) in self.sources.iter().enumerate() {
            for k in 0..6 {
                let column = 6 * number + k;
                match source {
                    Source::Coordinates(first) => direct[(first + k, column)] = 1.0,
                    Source::Mean(rows) => {
                        for (node, block) in rows {
                            for i in 0..3 {
                                full[(3 * node + i, column)] = block[k][i];
                            }
                        }
                    }
                }
            }
        }
        direct + coordinates.contract(full.as_ref())
    }
}
