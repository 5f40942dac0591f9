//! Force elements of any kind.

use ffrf_codegen::mechanism::soft_row_count;
use ffrf_runtime::forces::{Bushing, ConstantWrench, ForceElement, Friction, SoftRow, Spring, TorsionSpring};
use ffrf_runtime::{MarkerMotion, MarkerStep, Wrench};
use nalgebra::{RealField, Vector3, convert};

/// A force element and what it is attached to.
pub type Element<T = f64> = ffrf_runtime::mechanism::Element<ElementKind<T>, T>;

/// What acts between two attachments.
#[derive(Debug, Clone, PartialEq)]
pub enum ElementKind<T: RealField + Copy = f64> {
    /// See [`Spring`].
    Spring(Spring<T>),
    /// See [`TorsionSpring`].
    TorsionSpring(TorsionSpring<T>),
    /// See [`Bushing`].
    Bushing(Bushing<T>),
    /// See [`Friction`].
    Friction(Friction<T>),
    /// See [`ConstantWrench`].
    Constant(ConstantWrench<T>),
}

impl<T: RealField + Copy> ElementKind<T> {
    /// Whether this is a force or moment with a direction, which can be an input.
    pub fn grows(&self) -> bool {
        matches!(self, Self::Constant(ConstantWrench { force, moment, .. })
            if force.norm_squared() + moment.norm_squared() > T::zero())
    }

    /// Makes a force or moment larger by `amount` (N or N m) along its own direction; other elements stay.
    pub fn grow(&mut self, amount: T) {
        if let Self::Constant(ConstantWrench { force, moment, .. }) = self {
            for vector in [force, moment] {
                if vector.norm_squared() > T::zero() {
                    *vector += *vector / vector.norm() * amount;
                }
            }
        }
    }

    /// The number of its soft rows, if implicit steps take it into their matrix.
    pub(super) fn soft_row_count(&self) -> Option<usize> {
        soft_row_count(match self {
            Self::Spring(_) => "Spring",
            Self::TorsionSpring(_) => "TorsionSpring",
            Self::Bushing(_) => "Bushing",
            Self::Friction(_) => "Friction",
            Self::Constant(_) => "ConstantWrench",
        })
    }

    fn as_element(&self) -> &dyn ForceElement<T> {
        match self {
            Self::Spring(element) => element,
            Self::TorsionSpring(element) => element,
            Self::Bushing(element) => element,
            Self::Friction(element) => element,
            Self::Constant(element) => element,
        }
    }
}

impl<T: RealField + Copy> ForceElement<T> for ElementKind<T> {
    fn wrenches(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> [Wrench<T>; 2] {
        self.as_element().wrenches(first, second)
    }

    fn wrenches_over(&self, first: &MarkerStep<T>, second: &MarkerStep<T>) -> [Wrench<T>; 2] {
        self.as_element().wrenches_over(first, second)
    }

    fn soften(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>, push: &mut dyn FnMut(SoftRow<T>)) {
        self.as_element().soften(first, second, push);
    }

    fn energy(&self, first: &MarkerMotion<T>, second: &MarkerMotion<T>) -> T {
        self.as_element().energy(first, second)
    }
}

impl ElementKind {
    /// The same element in another number type.
    pub fn cast<T: RealField + Copy>(&self) -> ElementKind<T> {
        let number = |x: f64| convert::<f64, T>(x);
        let vector = |vector: &Vector3<f64>| vector.map(number);
        match self {
            Self::Spring(spring) => ElementKind::Spring(Spring {
                stiffness: number(spring.stiffness),
                damping: number(spring.damping),
                rest_length: number(spring.rest_length),
            }),
            Self::TorsionSpring(spring) => ElementKind::TorsionSpring(TorsionSpring {
                stiffness: number(spring.stiffness),
                damping: number(spring.damping),
                rest_angle: number(spring.rest_angle),
            }),
            Self::Bushing(bushing) => ElementKind::Bushing(Bushing {
                stiffness: bushing.stiffness.map(number),
                damping: bushing.damping.map(number),
            }),
            Self::Friction(friction) => ElementKind::Friction(friction.cast()),
            Self::Constant(wrench) => ElementKind::Constant(ConstantWrench {
                force: vector(&wrench.force),
                moment: vector(&wrench.moment),
                frame: wrench.frame,
            }),
        }
    }
}
