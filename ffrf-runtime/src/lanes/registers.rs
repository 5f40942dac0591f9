//! Which registers the loops compute in: those that the code is compiled for, or those that a processor was found to have.

use super::{Everywhere, Four, HasLanes, Lanes, Scalar};

/// Registers of `W` lanes. A value of this type is the proof that they are there.
pub trait Width<T, const W: usize>: Copy {
    /// The register.
    type Lanes: Lanes<T, W>;
    /// The numbers, one per lane.
    fn load(self, numbers: &[T; W]) -> Self::Lanes;
    /// One number in every lane.
    fn splat(self, number: T) -> Self::Lanes;
}

/// A processor, or the least that is known of it when compiling.
pub trait Processor: Copy {
    /// Whether functions are compiled for it as they stand; else only what is inlined into [`Processor::run`].
    const IS_COMPILED_FOR: bool;
    /// Runs a closure, compiled for this processor as far as it is inlined.
    fn run<O>(self, work: impl FnOnce() -> O) -> O;
}

/// Registers of four and eight lanes, and what goes with them.
pub trait Registers<T>: Processor + Width<T, 4, Lanes: Four<T>> + Width<T, 8> {
    /// Whether there are enough registers for a dozen sums of eight lanes; else they are worked through by fours.
    const HAS_ROOM_FOR_EIGHTS: bool;
    /// `a * b + c`, fused where that is an instruction.
    fn multiply_add(self, a: T, b: T, c: T) -> T;
}

/// The registers of the target that the code is compiled for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Compiled;

impl<T: HasLanes<W>, const W: usize> Width<T, W> for Compiled {
    type Lanes = <T as HasLanes<W>>::Lanes;

    #[inline(always)]
    fn load(self, numbers: &[T; W]) -> Self::Lanes {
        Everywhere::load(numbers)
    }

    #[inline(always)]
    fn splat(self, number: T) -> Self::Lanes {
        Everywhere::splat(number)
    }
}

impl<T: Scalar> Registers<T> for Compiled {
    const HAS_ROOM_FOR_EIGHTS: bool = true;

    #[inline(always)]
    fn multiply_add(self, a: T, b: T, c: T) -> T {
        a.multiply_add(b, c)
    }
}

impl Processor for Compiled {
    const IS_COMPILED_FOR: bool = true;

    #[inline(always)]
    fn run<O>(self, work: impl FnOnce() -> O) -> O {
        work()
    }
}
