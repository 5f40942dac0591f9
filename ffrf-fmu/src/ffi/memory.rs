//! Reading and writing what callers point at.

use std::ffi::{CStr, c_char};

use super::handle::Failure;

/// The elements that a caller points at.
///
/// # Safety
/// `pointer` is null or leads to `count` elements, which nobody changes while the result lives.
pub(super) unsafe fn elements<'a, T>(pointer: *const T, count: usize) -> Result<&'a [T], Failure> {
    if count == 0 {
        return Ok(&[]);
    }
    if pointer.is_null() {
        return Err(Failure::null());
    }
    // SAFETY: not null, and the caller says that there are `count` elements.
    Ok(unsafe { std::slice::from_raw_parts(pointer, count) })
}

/// The elements that a caller wants to be written.
///
/// # Safety
/// `pointer` is null or leads to `count` elements that nobody else uses while the result lives.
pub(super) unsafe fn places<'a, T>(pointer: *mut T, count: usize) -> Result<&'a mut [T], Failure> {
    if count == 0 {
        return Ok(&mut []);
    }
    if pointer.is_null() {
        return Err(Failure::null());
    }
    // SAFETY: not null, and the caller says that there are `count` elements for us alone.
    Ok(unsafe { std::slice::from_raw_parts_mut(pointer, count) })
}

/// Writes one value.
///
/// # Safety
/// `place` is null or leads to a place for a value.
pub(super) unsafe fn put<T>(place: *mut T, value: T) -> Result<(), Failure> {
    if place.is_null() {
        return Err(Failure::null());
    }
    // SAFETY: not null, and the caller says that a value can be written there.
    unsafe { place.write(value) };
    Ok(())
}

/// A text; empty if there is none.
///
/// # Safety
/// `pointer` is null or leads to a text that ends in a zero.
pub(super) unsafe fn text(pointer: *const c_char) -> String {
    if pointer.is_null() {
        return String::new();
    }
    // SAFETY: not null, and the caller says that the text ends in a zero.
    unsafe { CStr::from_ptr(pointer) }.to_string_lossy().into_owned()
}
