//! Functions of FMI 3.0 that every binary has and that mean nothing for these FMUs: other kinds of simulation, other types
//! of variables, clocks, derivatives. They answer with an error, or do nothing where nothing is asked for.
#![allow(non_snake_case, missing_docs, clippy::missing_safety_doc)]

use std::ffi::{c_char, c_int, c_void};

use super::handle::{Failure, OK, Status, with};

macro_rules! absent {
    ($($name:ident($($argument:ty),*);)*) => {
        $(
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn $name(instance: *mut c_void, $(_: $argument),*) -> Status {
                // SAFETY: the contract of the module above.
                unsafe { with(instance, |_| Err(Failure::new(concat!(stringify!($name), ": this FMU has no such thing")))) }
            }
        )*
    };
}

/// Access to variables of a type that there are none of: the number of value references comes second.
macro_rules! no_variables {
    ($($name:ident($($argument:ty),*);)*) => {
        $(
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn $name(
                instance: *mut c_void, _references: *const u32, reference_count: usize, $(_: $argument),*
            ) -> Status {
                // SAFETY: the contract of the module above.
                unsafe {
                    with(instance, |_| match reference_count {
                        0 => Ok(OK),
                        _ => Err(Failure::new(concat!(stringify!($name), ": this FMU has no variables of that type"))),
                    })
                }
            }
        )*
    };
}

type Name = *const c_char;

#[unsafe(no_mangle)]
pub extern "C" fn fmi3InstantiateModelExchange(
    _: Name,
    _: Name,
    _: Name,
    _: bool,
    _: bool,
    _: *mut c_void,
    _: *const c_void,
) -> *mut c_void {
    std::ptr::null_mut()
}

#[unsafe(no_mangle)]
#[allow(clippy::too_many_arguments)] // the standard's
pub extern "C" fn fmi3InstantiateScheduledExecution(
    _: Name,
    _: Name,
    _: Name,
    _: bool,
    _: bool,
    _: *mut c_void,
    _: *const c_void,
    _: *const c_void,
    _: *const c_void,
    _: *const c_void,
) -> *mut c_void {
    std::ptr::null_mut()
}

no_variables! {
    fmi3GetFloat32(*mut f32, usize);
    fmi3GetInt8(*mut i8, usize);
    fmi3GetUInt8(*mut u8, usize);
    fmi3GetInt16(*mut i16, usize);
    fmi3GetUInt16(*mut u16, usize);
    fmi3GetInt32(*mut i32, usize);
    fmi3GetUInt32(*mut u32, usize);
    fmi3GetInt64(*mut i64, usize);
    fmi3GetUInt64(*mut u64, usize);
    fmi3GetBoolean(*mut bool, usize);
    fmi3GetString(*mut Name, usize);
    fmi3GetBinary(*mut usize, *mut *const u8, usize);
    fmi3GetClock(*mut bool);
    fmi3SetFloat32(*const f32, usize);
    fmi3SetInt8(*const i8, usize);
    fmi3SetUInt8(*const u8, usize);
    fmi3SetInt16(*const i16, usize);
    fmi3SetUInt16(*const u16, usize);
    fmi3SetInt32(*const i32, usize);
    fmi3SetUInt32(*const u32, usize);
    fmi3SetInt64(*const i64, usize);
    fmi3SetUInt64(*const u64, usize);
    fmi3SetBoolean(*const bool, usize);
    fmi3SetString(*const Name, usize);
    fmi3SetBinary(*const usize, *const *const u8, usize);
    fmi3SetClock(*const bool);
    fmi3GetIntervalDecimal(*mut f64, *mut c_int);
    fmi3GetIntervalFraction(*mut u64, *mut u64, *mut c_int);
    fmi3GetShiftDecimal(*mut f64);
    fmi3GetShiftFraction(*mut u64, *mut u64);
    fmi3SetIntervalDecimal(*const f64);
    fmi3SetIntervalFraction(*const u64, *const u64);
    fmi3SetShiftDecimal(*const f64);
    fmi3SetShiftFraction(*const u64, *const u64);
    fmi3GetOutputDerivatives(*const i32, *mut f64, usize);
}

absent! {
    fmi3EnterEventMode();
    fmi3GetNumberOfVariableDependencies(u32, *mut usize);
    fmi3GetVariableDependencies(u32, *mut usize, *mut u32, *mut usize, *mut c_int, usize);
    fmi3GetDirectionalDerivative(*const u32, usize, *const u32, usize, *const f64, usize, *mut f64, usize);
    fmi3GetAdjointDerivative(*const u32, usize, *const u32, usize, *const f64, usize, *mut f64, usize);
    fmi3EnterConfigurationMode();
    fmi3ExitConfigurationMode();
    fmi3EvaluateDiscreteStates();
    fmi3UpdateDiscreteStates(*mut bool, *mut bool, *mut bool, *mut bool, *mut bool, *mut f64);
    fmi3EnterContinuousTimeMode();
    fmi3CompletedIntegratorStep(bool, *mut bool, *mut bool);
    fmi3SetTime(f64);
    fmi3SetContinuousStates(*const f64, usize);
    fmi3GetContinuousStateDerivatives(*mut f64, usize);
    fmi3GetEventIndicators(*mut f64, usize);
    fmi3GetContinuousStates(*mut f64, usize);
    fmi3GetNominalsOfContinuousStates(*mut f64, usize);
    fmi3GetNumberOfEventIndicators(*mut usize);
    fmi3GetNumberOfContinuousStates(*mut usize);
    fmi3EnterStepMode();
    fmi3ActivateModelPartition(u32, f64);
}
