//! The functions of FMI 3.0 for co-simulation. Names, arguments and answers are those of the standard (section 2.2, 4.2).
#![allow(non_snake_case, clippy::missing_safety_doc, clippy::too_many_arguments)]

use std::ffi::{c_char, c_void};
use std::path::PathBuf;

use super::handle::{
    self, CATEGORY_ERROR, ERROR, Failure, Handle, OK, Report, Status, c_text, free_state, put_state, state,
    with,
};
use super::memory::{elements, places, put, text};

/// Receives messages: environment, status, category, message.
pub type LogMessage = Option<unsafe extern "C" fn(*mut c_void, Status, *const c_char, *const c_char)>;

fn report(environment: *mut c_void, log: LogMessage) -> Report {
    Box::new(move |status, category, message| {
        if let Some(log) = log {
            let (category, message) = (c_text(category), c_text(message));
            // SAFETY: the caller gave function and environment to be called until the instance is freed.
            unsafe { log(environment, status, category.as_ptr(), message.as_ptr()) };
        }
    })
}

/// The version of the standard.
#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetVersion() -> *const c_char {
    c"3.0".as_ptr()
}

/// Whether more than errors is reported.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetDebugLogging(
    instance: *mut c_void,
    logging_on: bool,
    _category_count: usize,
    _categories: *const *const c_char,
) -> Status {
    // SAFETY: the contract of this module.
    unsafe {
        with(instance, |handle| {
            handle.logging = logging_on;
            Ok(OK)
        })
    }
}

/// An instance for co-simulation; null if the resources are not those of the token, or event mode is asked for.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateCoSimulation(
    _instance_name: *const c_char,
    instantiation_token: *const c_char,
    resource_path: *const c_char,
    _visible: bool,
    logging_on: bool,
    event_mode_used: bool,
    _early_return_allowed: bool,
    _required_intermediate_variables: *const u32,
    _required_intermediate_variable_count: usize,
    environment: *mut c_void,
    log_message: LogMessage,
    _intermediate_update: *const c_void,
) -> *mut c_void {
    let report = report(environment, log_message);
    if event_mode_used {
        report(ERROR, CATEGORY_ERROR, "event mode: this FMU has none");
        return std::ptr::null_mut();
    }
    // SAFETY: the contract of this module: texts end in a zero.
    let (token, folder) = unsafe { (text(instantiation_token), text(resource_path)) };
    handle::instantiate(&PathBuf::from(folder), &token, logging_on, report)
}

/// Frees an instance.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeInstance(instance: *mut c_void) {
    // SAFETY: the contract of this module.
    unsafe { handle::free(instance) }
}

/// Begins initialisation. The tolerance is that of the parameter `simulation.tolerance`, and the end is not needed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3EnterInitializationMode(
    instance: *mut c_void,
    _tolerance_defined: bool,
    _tolerance: f64,
    start_time: f64,
    _stop_time_defined: bool,
    _stop_time: f64,
) -> Status {
    // SAFETY: the contract of this module.
    unsafe { with(instance, |handle| Ok(handle.instance.enter_initialisation(start_time).map(|()| OK)?)) }
}

/// Ends initialisation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3ExitInitializationMode(instance: *mut c_void) -> Status {
    // SAFETY: the contract of this module.
    unsafe { with(instance, |handle| Ok(handle.instance.exit_initialisation().map(|()| OK)?)) }
}

/// Ends the simulation.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3Terminate(instance: *mut c_void) -> Status {
    // SAFETY: the contract of this module.
    unsafe { with(instance, |handle| Ok(handle.instance.terminate().map(|()| OK)?)) }
}

/// Makes an instance what it was when it was instantiated.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3Reset(instance: *mut c_void) -> Status {
    // SAFETY: the contract of this module.
    unsafe {
        with(instance, |handle| {
            handle.instance.reset();
            handle.stopped = false;
            Ok(OK)
        })
    }
}

/// Reads variables.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetFloat64(
    instance: *mut c_void,
    value_references: *const u32,
    reference_count: usize,
    values: *mut f64,
    value_count: usize,
) -> Status {
    // SAFETY: the contract of this module.
    unsafe {
        with(instance, |handle| {
            counts(reference_count, value_count)?;
            let (references, values) =
                (elements(value_references, reference_count)?, places(values, value_count)?);
            get(handle, references, values)
        })
    }
}

/// Sets parameters and inputs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetFloat64(
    instance: *mut c_void,
    value_references: *const u32,
    reference_count: usize,
    values: *const f64,
    value_count: usize,
) -> Status {
    // SAFETY: the contract of this module.
    unsafe {
        with(instance, |handle| {
            counts(reference_count, value_count)?;
            let (references, values) =
                (elements(value_references, reference_count)?, elements(values, value_count)?);
            set(handle, references, values)
        })
    }
}

fn counts(references: usize, values: usize) -> Result<(), Failure> {
    if references == values {
        return Ok(());
    }
    Err(Failure::new(format!("{references} variables and {values} values: every variable is one number")))
}

pub(super) fn get(handle: &mut Handle, references: &[u32], values: &mut [f64]) -> Result<Status, Failure> {
    for (reference, value) in references.iter().zip(values) {
        *value = handle.instance.get(*reference)?;
    }
    Ok(OK)
}

pub(super) fn set(handle: &mut Handle, references: &[u32], values: &[f64]) -> Result<Status, Failure> {
    for (reference, value) in references.iter().zip(values) {
        handle.instance.set(*reference, *value)?;
    }
    Ok(OK)
}

/// Saves the state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetFMUState(instance: *mut c_void, fmu_state: *mut *mut c_void) -> Status {
    // SAFETY: the contract of this module.
    unsafe { with(instance, |handle| put_state(fmu_state, handle.instance.save()).map(|()| OK)) }
}

/// Takes up a state again, bit by bit.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetFMUState(instance: *mut c_void, fmu_state: *mut c_void) -> Status {
    // SAFETY: the contract of this module.
    unsafe { with(instance, |handle| resume(handle, fmu_state)) }
}

/// Takes up a state.
///
/// # Safety
/// `fmu_state` is null or a state that was not freed.
pub(super) unsafe fn resume(handle: &mut Handle, fmu_state: *mut c_void) -> Result<Status, Failure> {
    // SAFETY: as this function.
    let saved = unsafe { state(fmu_state) }?;
    handle.instance.resume(saved)?;
    handle.stopped = false;
    Ok(OK)
}

/// Frees a state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeFMUState(instance: *mut c_void, fmu_state: *mut *mut c_void) -> Status {
    // SAFETY: the contract of this module.
    unsafe {
        with(instance, |_| {
            free_state(fmu_state);
            Ok(OK)
        })
    }
}

/// The number of bytes of a state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SerializedFMUStateSize(
    instance: *mut c_void,
    fmu_state: *mut c_void,
    size: *mut usize,
) -> Status {
    // SAFETY: the contract of this module.
    unsafe {
        with(instance, |handle| {
            put(size, handle.instance.write_state(state(fmu_state)?).len())?;
            Ok(OK)
        })
    }
}

/// A state as bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SerializeFMUState(
    instance: *mut c_void,
    fmu_state: *mut c_void,
    serialized_state: *mut u8,
    size: usize,
) -> Status {
    // SAFETY: the contract of this module.
    unsafe {
        with(instance, |handle| {
            let bytes = handle.instance.write_state(state(fmu_state)?);
            if size < bytes.len() {
                return Err(Failure::new(format!(
                    "a state takes {} bytes, found place for {size}",
                    bytes.len()
                )));
            }
            places(serialized_state, bytes.len())?.copy_from_slice(&bytes);
            Ok(OK)
        })
    }
}

/// A state from its bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DeserializeFMUState(
    instance: *mut c_void,
    serialized_state: *const u8,
    size: usize,
    fmu_state: *mut *mut c_void,
) -> Status {
    // SAFETY: the contract of this module.
    unsafe {
        with(instance, |handle| {
            let saved = handle.instance.read_state(elements(serialized_state, size)?)?;
            put_state(fmu_state, saved).map(|()| OK)
        })
    }
}

/// One step from a communication point to the next.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DoStep(
    instance: *mut c_void,
    current_communication_point: f64,
    communication_step_size: f64,
    _no_set_fmu_state_prior_to_current_point: bool,
    event_handling_needed: *mut bool,
    terminate_simulation: *mut bool,
    early_return: *mut bool,
    last_successful_time: *mut f64,
) -> Status {
    // SAFETY: the contract of this module.
    unsafe {
        with(instance, |handle| {
            let arrival = handle.instance.step(current_communication_point, communication_step_size)?;
            handle.report_events(&arrival.events);
            put(event_handling_needed, false)?;
            put(terminate_simulation, arrival.stopped)?;
            put(early_return, false)?;
            put(last_successful_time, arrival.time)?;
            Ok(OK)
        })
    }
}
