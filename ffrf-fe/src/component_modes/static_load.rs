//! Static correction: loads whose deformation at rest a basis shall hold exactly.

use faer::Mat;
use ffrf_model::{ModeKind, Vector3};

use crate::{FeError, FeModel};

use super::ComponentModeError;
use super::constrained::Constrained;
use super::flexibility::Flexibility;
use super::shapes::Shapes;

/// Forces on nodes that belong together.
#[derive(Debug, Clone, PartialEq)]
pub struct StaticLoad {
    /// Node rows and forces. Units: N. Frame: body.
    pub forces: Vec<(usize, Vector3)>,
}

impl StaticLoad {
    /// A force spread evenly over nodes. Only its direction matters to the basis.
    pub fn uniform(nodes: &[usize], force: Vector3) -> Self {
        let share = force.map(|x| x / nodes.len().max(1) as f64);
        Self { forces: nodes.iter().map(|&row| (row, share)).collect() }
    }
}

/// Static shapes of loads: with the interfaces at rest if `constrained` is given, balanced by inertia if not.
///
/// Errors: unknown rows, forces that are not finite.
pub(crate) fn shapes(
    model: &FeModel,
    flexibility: &Flexibility<'_>,
    constrained: Option<&Constrained<'_>>,
    loads: &[StaticLoad],
) -> Result<Shapes, FeError> {
    let nodes = model.nodes.len();
    let mut full = Mat::zeros(3 * nodes, loads.len());
    for (j, load) in loads.iter().enumerate() {
        for &(row, force) in &load.forces {
            if row >= nodes {
                return Err(ComponentModeError::Size {
                    what: "node row of a static load".to_owned(),
                    expected: nodes - 1,
                    found: row,
                }
                .into());
            }
            for (i, value) in force.into_iter().enumerate() {
                if !value.is_finite() {
                    let (what, expected) = ("static load".to_owned(), "finite forces".to_owned());
                    return Err(ComponentModeError::Number { what, expected, found: value }.into());
                }
                full[(3 * row + i, j)] += value;
            }
        }
    }
    let forces = flexibility.coordinates.contract(full.as_ref());
    let columns = match constrained {
        Some(constrained) => {
            let rest = Mat::zeros(constrained.motion.count(), loads.len());
            constrained.solve_refined(forces.as_ref(), rest.as_ref())
        }
        None => flexibility.elastic_refined(forces),
    };
    Ok(Shapes::of_kind(columns, ModeKind::Attachment))
}
