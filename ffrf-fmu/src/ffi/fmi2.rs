//! The functions of FMI 2.0 for co-simulation. Names, arguments and answers are those of the standard (section 2.1, 4.2).
#![allow(non_snake_case, clippy::missing_safety_doc)]

use std::ffi::{c_char, c_int, c_void};
use std::path::PathBuf;

use super::fmi3::{
    fmi3DeserializeFMUState, fmi3ExitInitializationMode, fmi3FreeFMUState, fmi3GetFMUState, fmi3Reset,
    fmi3SerializeFMUState, fmi3SerializedFMUStateSize, fmi3SetFMUState, fmi3Terminate, get, set,
};
use super::handle::{self, CATEGORY_ERROR, DISCARD, ERROR, Failure, OK, Report, Status, c_text, with};
use super::memory::{elements, places, put, text};

/// Receives messages: environment, name of the instance, status, category, format of C and what it formats.
pub type Logger =
    Option<unsafe extern "C" fn(*mut c_void, *const c_char, Status, *const c_char, *const c_char, ...)>;

/// What the caller offers.
#[repr(C)]
pub struct CallbackFunctions {
    /// Receives messages.
    pub logger: Logger,
    /// Not used: memory is that of Rust.
    pub allocate_memory: *const c_void,
    /// Not used.
    pub free_memory: *const c_void,
    /// Not used: steps end before they return.
    pub step_finished: *const c_void,
    /// Passed back with messages.
    pub environment: *mut c_void,
}

/// The kind that is made: co-simulation.
const CO_SIMULATION: c_int = 1;
/// What is asked of the last step: its end, and whether the simulation has ended.
const LAST_SUCCESSFUL_TIME: c_int = 2;
const TERMINATED: c_int = 3;

fn report(name: &str, environment: *mut c_void, logger: Logger) -> Report {
    let name = c_text(name);
    Box::new(move |status, category, message| {
        if let Some(log) = logger {
            let (category, message) = (c_text(category), c_text(message));
            // SAFETY: the caller gave function and environment to be called until the instance is freed; the format takes
            // one text.
            unsafe {
                log(environment, name.as_ptr(), status, category.as_ptr(), c"%s".as_ptr(), message.as_ptr());
            }
        }
    })
}

/// The types of the standard's own header.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetTypesPlatform() -> *const c_char {
    c"default".as_ptr()
}

/// The version of the standard.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetVersion() -> *const c_char {
    c"2.0".as_ptr()
}

/// Whether more than errors is reported.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetDebugLogging(
    component: *mut c_void,
    logging_on: c_int,
    _category_count: usize,
    _categories: *const *const c_char,
) -> Status {
    // SAFETY: the contract of this module.
    unsafe {
        with(component, |handle| {
            handle.logging = logging_on != 0;
            Ok(OK)
        })
    }
}

/// An instance for co-simulation; null if the resources are not those of the token, or model exchange is asked for.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Instantiate(
    instance_name: *const c_char,
    fmu_type: c_int,
    guid: *const c_char,
    resource_location: *const c_char,
    functions: *const CallbackFunctions,
    _visible: c_int,
    logging_on: c_int,
) -> *mut c_void {
    // SAFETY: the contract of this module: null, or the functions of the standard's structure.
    let functions = unsafe { functions.as_ref() };
    // SAFETY: texts end in a zero.
    let (name, token, location) = unsafe { (text(instance_name), text(guid), text(resource_location)) };
    let (environment, logger) =
        functions.map_or((std::ptr::null_mut(), None), |functions| (functions.environment, functions.logger));
    let report = report(&name, environment, logger);
    if fmu_type != CO_SIMULATION {
        report(ERROR, CATEGORY_ERROR, "this FMU is for co-simulation only");
        return std::ptr::null_mut();
    }
    match folder_of(&location) {
        Some(folder) => handle::instantiate(&folder, &token, logging_on != 0, report),
        None => {
            report(ERROR, CATEGORY_ERROR, &format!("resource location {location}: expected file:///..."));
            std::ptr::null_mut()
        }
    }
}

/// The folder that a URI of the scheme `file` names (RFC 8089, percent-encoding of RFC 3986), or the path itself.
fn folder_of(location: &str) -> Option<PathBuf> {
    let Some(path) = location.strip_prefix("file:") else {
        return (!location.contains("://") && !location.is_empty()).then(|| PathBuf::from(location));
    };
    let path = match path.strip_prefix("//") {
        Some(rest) => rest.strip_prefix("localhost").unwrap_or(rest),
        None => path,
    };
    let mut bytes = Vec::with_capacity(path.len());
    let mut rest = path.as_bytes();
    while let Some((first, after)) = rest.split_first() {
        let digits = after.get(..2).filter(|two| *first == b'%' && two.iter().all(u8::is_ascii_hexdigit));
        match digits
            .and_then(|two| std::str::from_utf8(two).ok())
            .and_then(|digits| u8::from_str_radix(digits, 16).ok())
        {
            Some(byte) => {
                bytes.push(byte);
                rest = &after[2..];
            }
            None => {
                bytes.push(*first);
                rest = after;
            }
        }
    }
    let path = String::from_utf8(bytes).ok()?;
    path.starts_with('/').then(|| PathBuf::from(path))
}

/// Frees an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeInstance(component: *mut c_void) {
    // SAFETY: the contract of this module.
    unsafe { handle::free(component) }
}

/// When the simulation begins. The tolerance is that of the parameter `simulation.tolerance`, and the end is not needed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetupExperiment(
    component: *mut c_void,
    _tolerance_defined: c_int,
    _tolerance: f64,
    start_time: f64,
    _stop_time_defined: c_int,
    _stop_time: f64,
) -> Status {
    // SAFETY: the contract of this module.
    unsafe {
        with(component, |handle| {
            handle.start = start_time;
            Ok(OK)
        })
    }
}

/// Begins initialisation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2EnterInitializationMode(component: *mut c_void) -> Status {
    // SAFETY: the contract of this module.
    unsafe {
        with(component, |handle| {
            let start = handle.start;
            Ok(handle.instance.enter_initialisation(start).map(|()| OK)?)
        })
    }
}

/// Functions that differ from those of FMI 3.0 by name alone.
macro_rules! as_in_fmi3 {
    ($($(#[$doc:meta])* $name:ident = $same:ident($($argument:ident: $kind:ty),*);)*) => {
        $(
            $(#[$doc])*
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn $name(component: *mut c_void, $($argument: $kind),*) -> Status {
                // SAFETY: the contract of this module.
                unsafe { $same(component, $($argument),*) }
            }
        )*
    };
}

as_in_fmi3! {
    /// Ends initialisation.
    fmi2ExitInitializationMode = fmi3ExitInitializationMode();
    /// Ends the simulation.
    fmi2Terminate = fmi3Terminate();
    /// Makes an instance what it was when it was instantiated.
    fmi2Reset = fmi3Reset();
    /// Saves the state.
    fmi2GetFMUstate = fmi3GetFMUState(state: *mut *mut c_void);
    /// Takes up a state again, bit by bit.
    fmi2SetFMUstate = fmi3SetFMUState(state: *mut c_void);
    /// Frees a state.
    fmi2FreeFMUstate = fmi3FreeFMUState(state: *mut *mut c_void);
    /// The number of bytes of a state.
    fmi2SerializedFMUstateSize = fmi3SerializedFMUStateSize(state: *mut c_void, size: *mut usize);
    /// A state as bytes.
    fmi2SerializeFMUstate = fmi3SerializeFMUState(state: *mut c_void, bytes: *mut u8, size: usize);
    /// A state from its bytes.
    fmi2DeSerializeFMUstate = fmi3DeserializeFMUState(bytes: *const u8, size: usize, state: *mut *mut c_void);
}

/// Reads variables.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetReal(
    component: *mut c_void,
    value_references: *const u32,
    count: usize,
    values: *mut f64,
) -> Status {
    // SAFETY: the contract of this module.
    unsafe {
        with(component, |handle| get(handle, elements(value_references, count)?, places(values, count)?))
    }
}

/// Sets parameters and inputs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetReal(
    component: *mut c_void,
    value_references: *const u32,
    count: usize,
    values: *const f64,
) -> Status {
    // SAFETY: the contract of this module.
    unsafe {
        with(component, |handle| set(handle, elements(value_references, count)?, elements(values, count)?))
    }
}

/// One step from a communication point to the next; `discard` if an event of the scene ends the simulation on the way.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2DoStep(
    component: *mut c_void,
    current_communication_point: f64,
    communication_step_size: f64,
    _no_set_fmu_state_prior_to_current_point: c_int,
) -> Status {
    // SAFETY: the contract of this module.
    unsafe {
        with(component, |handle| {
            let arrival = handle.instance.step(current_communication_point, communication_step_size)?;
            handle.report_events(&arrival.events);
            handle.stopped = arrival.stopped;
            Ok(if arrival.stopped { DISCARD } else { OK })
        })
    }
}

/// Whether the simulation has ended.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetBooleanStatus(
    component: *mut c_void,
    kind: c_int,
    value: *mut c_int,
) -> Status {
    // SAFETY: the contract of this module.
    unsafe {
        with(component, |handle| {
            if kind != TERMINATED {
                return Ok(DISCARD);
            }
            put(value, c_int::from(handle.stopped)).map(|()| OK)
        })
    }
}

/// The end of the last step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetRealStatus(component: *mut c_void, kind: c_int, value: *mut f64) -> Status {
    // SAFETY: the contract of this module.
    unsafe {
        with(component, |handle| {
            if kind != LAST_SUCCESSFUL_TIME {
                return Ok(DISCARD);
            }
            put(value, handle.instance.get(0)?).map(|()| OK)
        })
    }
}

/// What means nothing here: steps end before they return.
macro_rules! discarded {
    ($($name:ident($($argument:ty),*);)*) => {
        $(
            #[doc = "Answers `discard`: steps end before they return."]
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn $name(component: *mut c_void, $(_: $argument),*) -> Status {
                // SAFETY: the contract of this module.
                unsafe { with(component, |_| Ok(DISCARD)) }
            }
        )*
    };
}

discarded! {
    fmi2GetStatus(c_int, *mut c_int);
    fmi2GetIntegerStatus(c_int, *mut c_int);
    fmi2GetStringStatus(c_int, *mut *const c_char);
}

/// What these FMUs have none of: an error, or nothing where nothing is asked for.
macro_rules! no_variables {
    ($($name:ident($($argument:ty),*);)*) => {
        $(
            #[doc = "An error, or nothing where nothing is asked for: there is no such thing in these FMUs."]
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn $name(
                component: *mut c_void, _references: *const u32, count: usize, $(_: $argument),*
            ) -> Status {
                // SAFETY: the contract of this module.
                unsafe {
                    with(component, |_| match count {
                        0 => Ok(OK),
                        _ => Err(Failure::new(concat!(stringify!($name), ": this FMU has no such thing"))),
                    })
                }
            }
        )*
    };
}

no_variables! {
    fmi2GetInteger(*mut c_int);
    fmi2GetBoolean(*mut c_int);
    fmi2GetString(*mut *const c_char);
    fmi2SetInteger(*const c_int);
    fmi2SetBoolean(*const c_int);
    fmi2SetString(*const *const c_char);
    fmi2GetDirectionalDerivative(*const u32, usize, *const f64, *mut f64);
    fmi2SetRealInputDerivatives(*const c_int, *const f64);
    fmi2GetRealOutputDerivatives(*const c_int, *mut f64);
}

/// No step waits to be cancelled.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2CancelStep(component: *mut c_void) -> Status {
    // SAFETY: the contract of this module.
    unsafe { with(component, |_| Err(Failure::new("fmi2CancelStep: no step is under way"))) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn locations_of_resources_are_decoded() {
        for (location, folder) in [
            ("file:///tmp/a%20b/resources", Some("/tmp/a b/resources")),
            ("file:/tmp/resources", Some("/tmp/resources")),
            ("file://localhost/tmp/100%", Some("/tmp/100%")),
            ("/tmp/resources", Some("/tmp/resources")),
            ("http://tmp/resources", None),
            ("file://host/resources", None),
            ("", None),
        ] {
            assert_eq!(folder_of(location), folder.map(PathBuf::from), "{location}");
        }
    }
}
