//! What a caller holds: an instance and where its messages go.

use std::ffi::{CString, c_int, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use crate::instance::{Instance, InstanceError};
use crate::model::Model;
use crate::saved::Saved;

/// The answers of both versions of the standard.
pub type Status = c_int;
pub(super) const OK: Status = 0;
pub(super) const DISCARD: Status = 2;
pub(super) const ERROR: Status = 3;
pub(super) const FATAL: Status = 4;

/// Where messages go: status, category, message.
pub(super) type Report = Box<dyn Fn(Status, &str, &str)>;

pub(super) const CATEGORY_ERROR: &str = "logStatusError";
pub(super) const CATEGORY_EVENTS: &str = "logEvents";

/// What a caller holds.
pub(super) struct Handle {
    pub(super) instance: Instance,
    report: Report,
    /// Whether more than errors is reported.
    pub(super) logging: bool,
    /// Whether a panic has left it in an unknown state.
    broken: bool,
    /// Start time of FMI 2.0, which is said before initialisation. Units: s.
    pub(super) start: f64,
    /// Whether an event of the scene has ended the simulation.
    pub(super) stopped: bool,
}

/// Why a call fails.
pub(super) struct Failure(String);

impl Failure {
    pub(super) fn new(message: impl Into<String>) -> Self {
        Self(message.into())
    }

    pub(super) fn null() -> Self {
        Self::new("a null pointer was passed where a value is expected")
    }
}

impl From<InstanceError> for Failure {
    fn from(error: InstanceError) -> Self {
        Self(error.to_string())
    }
}

impl Handle {
    pub(super) fn report(&self, status: Status, category: &str, message: &str) {
        (self.report)(status, category, message);
    }

    /// Reports events of the scene, if that is asked for.
    pub(super) fn report_events(&self, events: &[String]) {
        for event in events.iter().filter(|_| self.logging) {
            self.report(OK, CATEGORY_EVENTS, event);
        }
    }
}

/// A new handle as a pointer; null, with a message, if the resources are not those of the model description.
pub(super) fn instantiate(folder: &Path, token: &str, logging: bool, report: Report) -> *mut c_void {
    let made = catch_unwind(AssertUnwindSafe(|| {
        let model = Model::in_resources(folder).map_err(|error| error.to_string())?;
        if model.token != token {
            return Err(format!(
                "the resources in {} are not those of this model description: token {}, expected {token}",
                folder.display(),
                model.token
            ));
        }
        Ok(Instance::new(model))
    }));
    match made {
        Ok(Ok(instance)) => {
            let handle = Handle { instance, report, logging, broken: false, start: 0.0, stopped: false };
            Box::into_raw(Box::new(handle)).cast()
        }
        Ok(Err(message)) => {
            report(ERROR, CATEGORY_ERROR, &message);
            std::ptr::null_mut()
        }
        Err(_) => {
            report(FATAL, CATEGORY_ERROR, PANICKED);
            std::ptr::null_mut()
        }
    }
}

const PANICKED: &str =
    "internal error: a panic, which is a defect of ffrf; the instance cannot be used any more";

/// Does something with an instance, and reports why it cannot be done.
///
/// # Safety
/// `pointer` is null or a handle that was not freed, and no other call uses it now.
pub(super) unsafe fn with(
    pointer: *mut c_void,
    act: impl FnOnce(&mut Handle) -> Result<Status, Failure>,
) -> Status {
    // SAFETY: null, or a handle that `instantiate` made and that this call uses alone.
    let Some(handle) = (unsafe { pointer.cast::<Handle>().as_mut() }) else { return ERROR };
    if handle.broken {
        return FATAL;
    }
    match catch_unwind(AssertUnwindSafe(|| act(handle))) {
        Ok(Ok(status)) => status,
        Ok(Err(Failure(message))) => {
            handle.report(ERROR, CATEGORY_ERROR, &message);
            ERROR
        }
        Err(_) => {
            handle.broken = true;
            handle.report(FATAL, CATEGORY_ERROR, PANICKED);
            FATAL
        }
    }
}

/// Frees a handle.
///
/// # Safety
/// `pointer` is null or a handle that was not freed; it is not used any more.
pub(super) unsafe fn free(pointer: *mut c_void) {
    if pointer.is_null() {
        return;
    }
    // SAFETY: `instantiate` made it of a box, and it was not freed.
    let handle = unsafe { Box::from_raw(pointer.cast::<Handle>()) };
    let _ = catch_unwind(AssertUnwindSafe(|| drop(handle)));
}

/// A state as a pointer in `place`, in place of one that is there.
///
/// # Safety
/// `place` is null or leads to a pointer that is null or a state that was not freed.
pub(super) unsafe fn put_state(place: *mut *mut c_void, saved: Saved) -> Result<(), Failure> {
    // SAFETY: null, or a place that leads to a pointer.
    let Some(place) = (unsafe { place.as_mut() }) else { return Err(Failure::null()) };
    // SAFETY: null, or a state that was made here and was not freed.
    match unsafe { place.cast::<Saved>().as_mut() } {
        Some(there) => *there = saved,
        None => *place = Box::into_raw(Box::new(saved)).cast(),
    }
    Ok(())
}

/// The state that a caller holds.
///
/// # Safety
/// `pointer` is null or a state that was not freed, and nobody changes it while the result lives.
pub(super) unsafe fn state<'a>(pointer: *mut c_void) -> Result<&'a Saved, Failure> {
    // SAFETY: null, or a state that was made here and was not freed.
    unsafe { pointer.cast::<Saved>().as_ref() }.ok_or_else(Failure::null)
}

/// Frees the state in `place` and leaves null there.
///
/// # Safety
/// `place` is null or leads to a pointer that is null or a state that was not freed.
pub(super) unsafe fn free_state(place: *mut *mut c_void) {
    // SAFETY: null, or a place that leads to a pointer.
    let Some(place) = (unsafe { place.as_mut() }) else { return };
    let pointer = std::mem::replace(place, std::ptr::null_mut());
    if !pointer.is_null() {
        // SAFETY: it was made of a box by `put_state`, and was not freed.
        drop(unsafe { Box::from_raw(pointer.cast::<Saved>()) });
    }
}

/// A text for C; zeros inside it are left out.
pub(super) fn c_text(text: &str) -> CString {
    CString::new(text.replace('\0', "")).unwrap_or_default()
}
