//! Inertia shape integrals over the volume.

use faer::{Mat, MatRef};

use super::element_points;
use crate::Element;
use crate::formulations::FormulationError;

/// The volume integrals of the classical floating frame of reference.
#[derive(Debug, Clone)]
pub struct ShapeIntegrals {
    /// m = ∫ρ dV. Units: kg.
    pub mass: f64,
    /// m aⁱ = ∫ρ xⁱ dV. Units: kg m. Source: (112).
    pub first_moment: [f64; 3],
    /// m b_μⁱ = ∫ρ φ_μⁱ dV. Source: (114).
    pub modal_first_moment: Vec<[f64; 3]>,
    /// T^{ij} = ∫ρ xⁱ xʲ dV. Shape: 3 x 3. Units: kg m². Source: (122).
    pub second_moment: Mat<f64>,
    /// T_μ^{ij} = ∫ρ xⁱ φ_μʲ dV. Shape: M of 3 x 3. Source: (125).
    pub position_mode_moment: Vec<Mat<f64>>,
    /// T_μν^{ij} = ∫ρ φ_μⁱ φ_νʲ dV. Shape: M of M of 3 x 3. Source: (131).
    pub mode_mode_moment: Vec<Vec<Mat<f64>>>,
}

/// Evaluates the integrals by Gauss quadrature, with x and φ interpolated at the points by (109) and (115).
///
/// Shape of `mode_shapes`: 3N x M. Units of `density`: kg/m³.
/// Errors: [`FormulationError::Element`], [`FormulationError::Size`].
pub fn shape_integrals(
    positions: &[[f64; 3]],
    elements: &[Element],
    density: f64,
    mode_shapes: MatRef<'_, f64>,
) -> Result<ShapeIntegrals, FormulationError> {
    let (expected, found) = (3 * positions.len(), mode_shapes.nrows());
    if expected != found {
        return Err(FormulationError::Size { what: "the matrix of mode shapes", expected, found });
    }
    let modes = mode_shapes.ncols();
    let zero = || Mat::zeros(3, 3);
    let mut integrals = ShapeIntegrals {
        mass: 0.0,
        first_moment: [0.0; 3],
        modal_first_moment: vec![[0.0; 3]; modes],
        second_moment: zero(),
        position_mode_moment: vec![zero(); modes],
        mode_mode_moment: vec![vec![zero(); modes]; modes],
    };
    for (number, element) in elements.iter().enumerate() {
        for point in element_points(positions, element, number)? {
            let interpolate = |value: &dyn Fn(usize, usize) -> f64| {
                [0, 1, 2].map(|i| {
                    point.shape.iter().zip(&element.nodes).map(|(n, &row)| n * value(row, i)).sum::<f64>()
                })
            };
            let x = interpolate(&|row, i| positions[row][i]);
            let phi: Vec<_> =
                (0..modes).map(|mu| interpolate(&|row, i| mode_shapes[(3 * row + i, mu)])).collect();
            integrals.add(density * point.volume, x, &phi);
        }
    }
    Ok(integrals)
}

impl ShapeIntegrals {
    fn add(&mut self, mass: f64, x: [f64; 3], phi: &[[f64; 3]]) {
        self.mass += mass;
        for i in 0..3 {
            self.first_moment[i] += mass * x[i];
        }
        add_outer(&mut self.second_moment, mass, x, x);
        for (mu, &shape) in phi.iter().enumerate() {
            for i in 0..3 {
                self.modal_first_moment[mu][i] += mass * shape[i];
            }
            add_outer(&mut self.position_mode_moment[mu], mass, x, shape);
            for (nu, &other) in phi.iter().enumerate() {
                add_outer(&mut self.mode_mode_moment[mu][nu], mass, shape, other);
            }
        }
    }
}

fn add_outer(sum: &mut Mat<f64>, factor: f64, u: [f64; 3], v: [f64; 3]) {
    for i in 0..3 {
        for j in 0..3 {
            sum[(i, j)] += factor * u[i] * v[j];
        }
    }
}
