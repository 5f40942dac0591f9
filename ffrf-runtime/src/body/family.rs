//! Families: bodies generated from one model that differ in modes, terms and number type.

use nalgebra::RealField;

use super::Observables;

/// What tells a member of a family from the others.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FamilyMember {
    /// Name of its type in the module of the family.
    pub name: &'static str,
    /// Number of modes M.
    pub modes: usize,
    /// Its fidelity, as it is written in the macro.
    pub fidelity: &'static str,
    /// Its number type, `f64` or `f32`.
    pub scalar: &'static str,
}

/// Does the same with every member of a family, each compiled on its own.
///
/// A family is made by `flexible_body!`; its function `for_each` calls [`visit`](Self::visit) once for each member.
pub trait FamilyVisitor {
    /// One member.
    fn visit<T: RealField + Copy, B: Observables<T> + Copy>(&mut self, member: FamilyMember, body: B);
}
