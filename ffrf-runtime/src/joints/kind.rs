//! Every joint as data, for mechanisms that are read from a file.

use nalgebra::RealField;

use super::{
    Angle, ConstantOrientation, Cylindrical, Distance, Fixed, Generic, InLine, InPlane, Joint, JointShape,
    Planar, Prismatic, Revolute, Spherical, Travel, Universal,
};
use crate::body::MarkerMotion;
use crate::relations::Rows;

/// A joint of any kind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum JointKind<T = f64> {
    /// The angle about the z axis of the first triad follows a drive; goes with a joint that keeps the z axes together.
    Angle(Angle),
    /// Both triads keep the same orientation: three translations are left.
    ConstantOrientation(ConstantOrientation),
    /// The z axes are one line: one rotation and the travel along it are left.
    Cylindrical(Cylindrical),
    /// The origins keep a distance.
    Distance(Distance<T>),
    /// Both triads coincide: no motion is left.
    Fixed(Fixed),
    /// Any choice of translations and rotations is held.
    Generic(Generic),
    /// The second origin stays on the z axis of the first triad.
    InLine(InLine),
    /// The second origin stays in the xy plane of the first triad.
    InPlane(InPlane),
    /// The xy planes are one: two translations and the rotation about z are left.
    Planar(Planar),
    /// The z axes are one line and nothing turns: the travel along it is left.
    Prismatic(Prismatic),
    /// The origins coincide and the z axes agree: one rotation is left.
    Revolute(Revolute),
    /// The origins coincide: three rotations are left.
    Spherical(Spherical),
    /// The second origin's coordinate along the z axis of the first triad follows a drive.
    Travel(Travel),
    /// The origins coincide and the z axes stay at right angles: two rotations are left.
    Universal(Universal),
}

impl<T: RealField + Copy> JointKind<T> {
    /// Number of rows.
    pub fn row_count(&self) -> usize {
        match self {
            Self::Generic(Generic { translation, rotation }) => {
                translation.iter().chain(rotation).filter(|held| **held).count()
            }
            Self::Angle(_) => Angle::ROWS.len(),
            Self::ConstantOrientation(_) => ConstantOrientation::ROWS.len(),
            Self::Cylindrical(_) => Cylindrical::ROWS.len(),
            Self::Distance(_) => Distance::<T>::ROWS.len(),
            Self::Fixed(_) => Fixed::ROWS.len(),
            Self::InLine(_) => InLine::ROWS.len(),
            Self::InPlane(_) => InPlane::ROWS.len(),
            Self::Planar(_) => Planar::ROWS.len(),
            Self::Prismatic(_) => Prismatic::ROWS.len(),
            Self::Revolute(_) => Revolute::ROWS.len(),
            Self::Spherical(_) => Spherical::ROWS.len(),
            Self::Travel(_) => Travel::ROWS.len(),
            Self::Universal(_) => Universal::ROWS.len(),
        }
    }

    /// Whether its first three rows keep both origins together, in inertial components.
    pub fn holds_point(&self) -> bool {
        matches!(self, Self::Fixed(_) | Self::Revolute(_) | Self::Spherical(_) | Self::Universal(_))
    }

    /// How many of its rows, the first ones, hold translations: forces alone at its second end. The others are moments alone.
    pub fn held_translations(&self) -> usize {
        match self {
            Self::Fixed(_) | Self::Revolute(_) | Self::Spherical(_) | Self::Universal(_) => 3,
            Self::Cylindrical(_) | Self::InLine(_) | Self::Prismatic(_) => 2,
            Self::Distance(_) | Self::InPlane(_) | Self::Planar(_) | Self::Travel(_) => 1,
            Self::Angle(_) | Self::ConstantOrientation(_) => 0,
            Self::Generic(Generic { translation, .. }) => translation.iter().filter(|held| **held).count(),
        }
    }

    /// What row `row` holds, for reports.
    pub fn row_name(&self, row: usize) -> &'static str {
        let names = match self {
            Self::Generic(Generic { translation, rotation }) => {
                let held = Fixed::ROWS.iter().zip(translation.iter().chain(rotation));
                return held.filter(|(_, held)| **held).nth(row).map_or("", |(name, _)| name);
            }
            Self::Angle(_) => Angle::ROWS,
            Self::ConstantOrientation(_) => ConstantOrientation::ROWS,
            Self::Cylindrical(_) => Cylindrical::ROWS,
            Self::Distance(_) => Distance::<T>::ROWS,
            Self::Fixed(_) => Fixed::ROWS,
            Self::InLine(_) => InLine::ROWS,
            Self::InPlane(_) => InPlane::ROWS,
            Self::Planar(_) => Planar::ROWS,
            Self::Prismatic(_) => Prismatic::ROWS,
            Self::Revolute(_) => Revolute::ROWS,
            Self::Spherical(_) => Spherical::ROWS,
            Self::Travel(_) => Travel::ROWS,
            Self::Universal(_) => Universal::ROWS,
        };
        names.get(row).copied().unwrap_or("")
    }
}

impl JointKind<f64> {
    /// The same joint in another number type.
    pub fn cast<T: RealField + Copy>(&self) -> JointKind<T> {
        match *self {
            Self::Angle(joint) => JointKind::Angle(joint),
            Self::ConstantOrientation(joint) => JointKind::ConstantOrientation(joint),
            Self::Cylindrical(joint) => JointKind::Cylindrical(joint),
            Self::Distance(Distance { length }) => {
                JointKind::Distance(Distance { length: nalgebra::convert(length) })
            }
            Self::Fixed(joint) => JointKind::Fixed(joint),
            Self::Generic(joint) => JointKind::Generic(joint),
            Self::InLine(joint) => JointKind::InLine(joint),
            Self::InPlane(joint) => JointKind::InPlane(joint),
            Self::Planar(joint) => JointKind::Planar(joint),
            Self::Prismatic(joint) => JointKind::Prismatic(joint),
            Self::Revolute(joint) => JointKind::Revolute(joint),
            Self::Spherical(joint) => JointKind::Spherical(joint),
            Self::Travel(joint) => JointKind::Travel(joint),
            Self::Universal(joint) => JointKind::Universal(joint),
        }
    }
}

impl<T: RealField + Copy> Joint<T> for JointKind<T> {
    fn push_rows(
        &self,
        rows: &mut Rows<T>,
        first: &MarkerMotion<T>,
        second: &MarkerMotion<T>,
        drive: &[T; 3],
    ) {
        match self {
            Self::Angle(joint) => joint.push_rows(rows, first, second, drive),
            Self::ConstantOrientation(joint) => joint.push_rows(rows, first, second, drive),
            Self::Cylindrical(joint) => joint.push_rows(rows, first, second, drive),
            Self::Distance(joint) => joint.push_rows(rows, first, second, drive),
            Self::Fixed(joint) => joint.push_rows(rows, first, second, drive),
            Self::Generic(joint) => joint.push_rows(rows, first, second, drive),
            Self::InLine(joint) => joint.push_rows(rows, first, second, drive),
            Self::InPlane(joint) => joint.push_rows(rows, first, second, drive),
            Self::Planar(joint) => joint.push_rows(rows, first, second, drive),
            Self::Prismatic(joint) => joint.push_rows(rows, first, second, drive),
            Self::Revolute(joint) => joint.push_rows(rows, first, second, drive),
            Self::Spherical(joint) => joint.push_rows(rows, first, second, drive),
            Self::Travel(joint) => joint.push_rows(rows, first, second, drive),
            Self::Universal(joint) => joint.push_rows(rows, first, second, drive),
        }
    }
}
