//! Every kind of joint, so that none can be forgotten.

use ffrf_runtime::joints::{
    Angle, ConstantOrientation, Cylindrical, Distance, Fixed, Generic, InLine, InPlane, JointKind, Planar,
    Prismatic, Revolute, Spherical, Travel, Universal,
};
use ffrf_runtime::nalgebra::{RealField, convert};

/// The kind after this one: a new kind does not compile until it has its place here.
fn next<T: RealField + Copy>(kind: Option<&JointKind<T>>) -> Option<JointKind<T>> {
    Some(match kind {
        None => JointKind::Angle(Angle),
        Some(JointKind::Angle(_)) => JointKind::ConstantOrientation(ConstantOrientation),
        Some(JointKind::ConstantOrientation(_)) => JointKind::Cylindrical(Cylindrical),
        Some(JointKind::Cylindrical(_)) => JointKind::Distance(Distance { length: convert(0.8) }),
        Some(JointKind::Distance(_)) => JointKind::Fixed(Fixed),
        Some(JointKind::Fixed(_)) => JointKind::Generic(held(1)),
        Some(JointKind::Generic(generic)) => match choice(generic) {
            63 => JointKind::InLine(InLine),
            choice => JointKind::Generic(held(choice + 1)),
        },
        Some(JointKind::InLine(_)) => JointKind::InPlane(InPlane),
        Some(JointKind::InPlane(_)) => JointKind::Planar(Planar),
        Some(JointKind::Planar(_)) => JointKind::Prismatic(Prismatic),
        Some(JointKind::Prismatic(_)) => JointKind::Revolute(Revolute),
        Some(JointKind::Revolute(_)) => JointKind::Spherical(Spherical),
        Some(JointKind::Spherical(_)) => JointKind::Travel(Travel),
        Some(JointKind::Travel(_)) => JointKind::Universal(Universal),
        Some(JointKind::Universal(_)) => return None,
    })
}

/// The generic joint that holds what the bits of `choice` say.
fn held(choice: u8) -> Generic {
    let bit = |k: usize| choice >> k & 1 == 1;
    Generic { translation: [bit(0), bit(1), bit(2)], rotation: [bit(3), bit(4), bit(5)] }
}

fn choice(generic: &Generic) -> u8 {
    let held = generic.translation.iter().chain(&generic.rotation).enumerate();
    held.map(|(k, held)| u8::from(*held) << k).sum()
}

/// Every kind once, the generic joint with every choice of what it holds.
pub fn every_kind<T: RealField + Copy>() -> Vec<JointKind<T>> {
    std::iter::successors(next(None), |kind| next(Some(kind))).collect()
}
