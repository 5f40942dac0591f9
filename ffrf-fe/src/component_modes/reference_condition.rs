//! Reference conditions: which frame the deformation is measured in.
//!
//! A rigid motion added to a mode changes the frame, not the part. Mean axes (Tisserand) keep the momenta of the
//! deformation at zero and the equations cheapest; a frame fixed to an interface or laid along a chord makes the
//! deformation there zero by definition.

use faer::linalg::solvers::Solve;
use faer::{Mat, MatRef};
use ffrf_model::Vector3;

use super::flexibility::Flexibility;
use super::interface_motion::InterfaceMotion;
use super::small::{cross, dot, norm, subtract};
use super::{ComponentModeError, Interface};

/// The frame that modal coordinates are measured in.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub enum ReferenceCondition {
    /// Mean axes (Tisserand, Buckens): modes take no momentum and no angular momentum along, b_μ = 0 and ϑ_μ = 0.
    #[default]
    MeanAxes,
    /// The frame moves with the reference point of an interface: no mode displaces or turns it (tangent frame).
    Fixed {
        /// Name of the interface.
        interface: String,
    },
    /// The frame has its origin at one interface and an axis through another; it turns about this chord with the
    /// first.
    Chord {
        /// Name of the interface that no mode displaces.
        from: String,
        /// Name of the interface that no mode displaces across the chord.
        to: String,
    },
}

impl ReferenceCondition {
    /// Number of the interface that the frame is tied to, if it is one.
    ///
    /// Errors: [`ComponentModeError::UnknownInterface`].
    pub(crate) fn tied_to(&self, interfaces: &[Interface]) -> Result<Option<usize>, ComponentModeError> {
        match self {
            Self::MeanAxes => Ok(None),
            Self::Fixed { interface } | Self::Chord { from: interface, .. } => {
                place(interfaces, interface).map(Some)
            }
        }
    }
}

/// The shapes with the rigid motion added that makes them fulfil the condition.
///
/// Errors: unknown interfaces, a chord without length, a part of which the export holds some rigid motions only.
pub(crate) fn apply(
    condition: &ReferenceCondition,
    flexibility: &Flexibility<'_>,
    motion: &InterfaceMotion,
    interfaces: &[Interface],
    mut shapes: Mat<f64>,
) -> Result<Mat<f64>, ComponentModeError> {
    let rigid = flexibility.rigid;
    if rigid.count() == 0 || *condition == ReferenceCondition::MeanAxes {
        rigid.remove_from(&mut shapes);
        return Ok(shapes);
    }
    check_free(rigid.count())?;
    let rows = condition_rows(condition, interfaces)?;
    let of = |shapes: MatRef<'_, f64>| &rows * motion.of(flexibility.coordinates, shapes);
    let amounts = of(rigid.shapes.as_ref()).partial_piv_lu().solve(of(shapes.as_ref()));
    Ok(shapes - flexibility.rigid_shapes(amounts.as_ref()))
}

/// Forces with the reactions that hold the frame: of inertia in mean axes, at the interfaces that it is tied to otherwise.
///
/// Errors: as those of [`apply`].
pub(crate) fn balance(
    condition: &ReferenceCondition,
    flexibility: &Flexibility<'_>,
    motion: &InterfaceMotion,
    interfaces: &[Interface],
    mut forces: Mat<f64>,
) -> Result<Mat<f64>, ComponentModeError> {
    let rigid = flexibility.rigid;
    if rigid.count() == 0 || *condition == ReferenceCondition::MeanAxes {
        rigid.balance(&mut forces);
        return Ok(forces);
    }
    check_free(rigid.count())?;
    let rows = condition_rows(condition, interfaces)?;
    let reactions = motion.forces(flexibility.coordinates) * rows.transpose();
    let of = |forces: MatRef<'_, f64>| rigid.shapes.transpose() * forces;
    let amounts = of(reactions.as_ref()).partial_piv_lu().solve(of(forces.as_ref()));
    Ok(forces - reactions * amounts)
}

/// A frame other than mean axes needs all six rigid motions.
fn check_free(found: usize) -> Result<(), ComponentModeError> {
    if found == 6 {
        return Ok(());
    }
    let what = "rigid motions that the export leaves, for a frame other than mean axes".to_owned();
    Err(ComponentModeError::Size { what, expected: 6, found })
}

/// Six rows on the motions of the interfaces that the condition makes zero.
fn condition_rows(
    condition: &ReferenceCondition,
    interfaces: &[Interface],
) -> Result<Mat<f64>, ComponentModeError> {
    let mut rows = Mat::zeros(6, 6 * interfaces.len());
    match condition {
        ReferenceCondition::MeanAxes => {}
        ReferenceCondition::Fixed { interface } => {
            let first = 6 * place(interfaces, interface)?;
            for i in 0..6 {
                rows[(i, first + i)] = 1.0;
            }
        }
        ReferenceCondition::Chord { from, to } => {
            let (a, b) = (place(interfaces, from)?, place(interfaces, to)?);
            let chord = subtract(interfaces[b].reference_point, interfaces[a].reference_point);
            let [along, across, upright] = axes(chord)?;
            for i in 0..3 {
                rows[(i, 6 * a + i)] = 1.0;
                rows[(3, 6 * b + i)] = across[i];
                rows[(4, 6 * b + i)] = upright[i];
                rows[(5, 6 * a + 3 + i)] = along[i];
            }
        }
    }
    Ok(rows)
}

/// An orthonormal triad with its first axis along the chord.
fn axes(chord: Vector3) -> Result<[Vector3; 3], ComponentModeError> {
    let length = norm(chord);
    if length.is_nan() || length <= 0.0 {
        return Err(ComponentModeError::Number {
            what: "length of the chord between two interfaces".to_owned(),
            expected: "more than 0".to_owned(),
            found: length,
        });
    }
    let along = chord.map(|x| x / length);
    let least = (0..3).fold(0, |best, i| if along[i].abs() < along[best].abs() { i } else { best });
    let mut helper = [0.0; 3];
    helper[least] = 1.0;
    let across = cross(along, helper);
    let across = across.map(|x| x / dot(across, across).sqrt());
    Ok([along, across, cross(along, across)])
}

pub(crate) fn place(interfaces: &[Interface], name: &str) -> Result<usize, ComponentModeError> {
    interfaces.iter().position(|interface| interface.name == name).ok_or_else(|| {
        ComponentModeError::UnknownInterface {
            interface: name.to_owned(),
            known: interfaces.iter().map(|interface| interface.name.as_str()).collect::<Vec<_>>().join(", "),
        }
    })
}
