//! Force elements of any kind.

use ffrf_runtime::forces::{Bushing, ConstantWrench, ForceElement, Friction, Spring, TorsionSpring};
use ffrf_runtime::{MarkerMotion, Wrench};

/// A force element and what it is attached to.
pub type Element = ffrf_runtime::mechanism::Element<ElementKind>;

/// What acts between two attachments.
#[derive(Debug, Clone, PartialEq)]
pub enum ElementKind {
    /// See [`Spring`].
    Spring(Spring),
    /// See [`TorsionSpring`].
    TorsionSpring(TorsionSpring),
    /// See [`Bushing`].
    Bushing(Bushing),
    /// See [`Friction`].
    Friction(Friction),
    /// See [`ConstantWrench`].
    Constant(ConstantWrench),
}

impl ElementKind {
    fn as_element(&self) -> &dyn ForceElement<f64> {
        match self {
            Self::Spring(element) => element,
            Self::TorsionSpring(element) => element,
            Self::Bushing(element) => element,
            Self::Friction(element) => element,
            Self::Constant(element) => element,
        }
    }
}

impl ForceElement<f64> for ElementKind {
    fn wrenches(&self, first: &MarkerMotion, second: &MarkerMotion) -> [Wrench; 2] {
        self.as_element().wrenches(first, second)
    }

    fn energy(&self, first: &MarkerMotion, second: &MarkerMotion) -> f64 {
        self.as_element().energy(first, second)
    }
}
