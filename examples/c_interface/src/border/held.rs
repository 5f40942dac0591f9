//! What C holds: memory of its own, in which Rust keeps an object.

use core::ffi::c_int;
use core::mem::{align_of, size_of};

use ffrf::StepError;

/// The answers, as the headers list them.
pub type Status = c_int;
pub(super) const OK: Status = 0;
pub(super) const NULL_POINTER: Status = 1;
pub(super) const NOT_INITIALISED: Status = 2;
pub(super) const NOT_FINITE: Status = 3;
pub(super) const STEP_SIZE: Status = 4;
pub(super) const STEP_REFUSED: Status = 5;
pub(super) const JOINTS_NOT_MET: Status = 6;
pub(super) const NO_STATE: Status = 7;

/// An object behind a mark that says it is there.
#[repr(C)]
pub(super) struct Held<T> {
    mark: u64,
    value: T,
}

impl<T: Copy> Held<T> {
    /// Whether an object fits into that many doubles of C.
    pub(super) const fn fits(doubles: usize) -> bool {
        size_of::<Self>() <= doubles * size_of::<f64>() && align_of::<Self>() <= align_of::<f64>()
    }
}

/// Puts an object into the memory of C.
///
/// # Safety
/// `memory` is null or leads to as many doubles as [`Held::fits`] was asked for.
pub(super) unsafe fn put<T: Copy>(memory: *mut f64, mark: u64, value: T) -> Status {
    if memory.is_null() {
        return NULL_POINTER;
    }
    // SAFETY: not null, large enough and aligned as `fits` has proven for the size that the caller says is there.
    unsafe { memory.cast::<Held<T>>().write(Held { mark, value }) };
    OK
}

/// The object in the memory of C. Errors: a null pointer, or no object there.
///
/// # Safety
/// `memory` is null or leads to as many doubles as [`Held::fits`] was asked for, which nobody else uses now.
pub(super) unsafe fn object<'a, T: Copy>(memory: *mut f64, mark: u64) -> Result<&'a mut T, Status> {
    if memory.is_null() {
        return Err(NULL_POINTER);
    }
    // SAFETY: not null; the mark stands first, and any bits are a number.
    if unsafe { memory.cast::<u64>().read() } != mark {
        return Err(NOT_INITIALISED);
    }
    // SAFETY: the mark says that `put` has written an object of this type here.
    Ok(unsafe { &mut (*memory.cast::<Held<T>>()).value })
}

/// Numbers that C gives. Errors: a null pointer, or a number that is not finite.
///
/// # Safety
/// `pointer` is null or leads to N doubles.
pub(super) unsafe fn numbers<const N: usize>(pointer: *const f64) -> Result<[f64; N], Status> {
    if pointer.is_null() {
        return Err(NULL_POINTER);
    }
    // SAFETY: not null, and the caller says that there are N doubles.
    let numbers = unsafe { pointer.cast::<[f64; N]>().read() };
    if numbers.iter().all(|number| number.is_finite()) { Ok(numbers) } else { Err(NOT_FINITE) }
}

/// Writes what C asks for. Errors: a null pointer.
///
/// # Safety
/// `place` is null or leads to a place for a value.
pub(super) unsafe fn write<T>(place: *mut T, value: T) -> Result<(), Status> {
    if place.is_null() {
        return Err(NULL_POINTER);
    }
    // SAFETY: not null, and the caller says that a value can be written there.
    unsafe { place.write(value) };
    Ok(())
}

/// The answer for what was done or not.
pub(super) fn status(result: Result<(), Status>) -> Status {
    result.err().unwrap_or(OK)
}

/// The answer for a step.
pub(super) fn of_step(error: StepError) -> Status {
    match error {
        StepError::StepSize { .. } => STEP_SIZE,
        StepError::ConstraintsNotMet { .. } => JOINTS_NOT_MET,
        _ => STEP_REFUSED,
    }
}

/// Whether Euler parameters are a rotation: what states that were saved here are, to round-off.
pub(super) fn is_rotation(parameters: &[f64]) -> bool {
    let square: f64 = parameters.iter().map(|number| number * number).sum();
    (square - 1.0).abs() < UNIT
}

/// Far above round-off of a norm, far below what anybody would call another orientation.
const UNIT: f64 = 1e-9;
