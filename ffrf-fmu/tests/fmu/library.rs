//! The library as other tools load it: its functions by their names, called as C calls them.
#![allow(unsafe_code)] // the other side of the border

use std::cell::RefCell;
use std::ffi::{CStr, CString, c_char, c_int, c_void};
use std::path::{Path, PathBuf};

use ffrf_host::scene::Scene;
use ffrf_host::simulate::simulate;

use crate::scenes::{Unpacked, known};

unsafe extern "C" {
    fn dlopen(path: *const c_char, flags: c_int) -> *mut c_void;
    fn dlsym(library: *mut c_void, name: *const c_char) -> *mut c_void;
}

/// Symbols are bound when the library is opened, and stay its own.
const RTLD_NOW: c_int = 2;

/// A library that stays open.
#[derive(Clone, Copy)]
pub struct Library(*mut c_void);

impl Library {
    /// The library that cargo has built with this test.
    fn built() -> Self {
        let folder = std::env::current_exe().unwrap().parent().unwrap().to_path_buf();
        Self::open(&folder.join(format!("libffrf_fmu{}", std::env::consts::DLL_SUFFIX)))
    }

    pub fn open(path: &Path) -> Self {
        let name = CString::new(path.display().to_string()).unwrap();
        // SAFETY: a text that ends in a zero; the library runs no code of its own when it is opened.
        let library = unsafe { dlopen(name.as_ptr(), RTLD_NOW) };
        assert!(!library.is_null(), "{} cannot be opened", path.display());
        Self(library)
    }

    pub fn find(&self, name: &str) -> *mut c_void {
        let text = CString::new(name).unwrap();
        // SAFETY: a library that is open, and a text that ends in a zero.
        let found = unsafe { dlsym(self.0, text.as_ptr()) };
        assert!(!found.is_null(), "the library has no {name}");
        found
    }
}

/// A function of the library in the type that the standard gives it.
macro_rules! function {
    ($library:expr, $name:literal, fn($($argument:ty),*) -> $result:ty) => {{
        // SAFETY: the type is that of the standard's headers for this name.
        unsafe { std::mem::transmute::<*mut c_void, unsafe extern "C" fn($($argument),*) -> $result>($library.find($name)) }
    }};
}

pub(crate) use function;

thread_local! {
    pub static MESSAGES: RefCell<Vec<String>> = const { RefCell::new(Vec::new()) };
}

unsafe extern "C" fn log(_: *mut c_void, status: c_int, _: *const c_char, message: *const c_char) {
    // SAFETY: the library gives a text that ends in a zero.
    let message = unsafe { CStr::from_ptr(message) }.to_string_lossy().into_owned();
    MESSAGES.with_borrow_mut(|messages| messages.push(format!("{status}: {message}")));
}

/// Functions of FMI 3.0 that every binary has (fmi3Functions.h).
pub const FMI3: &str = "GetVersion SetDebugLogging InstantiateModelExchange InstantiateCoSimulation \
    InstantiateScheduledExecution FreeInstance EnterInitializationMode ExitInitializationMode EnterEventMode Terminate Reset \
    GetFloat32 GetFloat64 GetInt8 GetUInt8 GetInt16 GetUInt16 GetInt32 GetUInt32 GetInt64 GetUInt64 GetBoolean GetString \
    GetBinary GetClock SetFloat32 SetFloat64 SetInt8 SetUInt8 SetInt16 SetUInt16 SetInt32 SetUInt32 SetInt64 SetUInt64 \
    SetBoolean SetString SetBinary SetClock GetNumberOfVariableDependencies GetVariableDependencies GetFMUState SetFMUState \
    FreeFMUState SerializedFMUStateSize SerializeFMUState DeserializeFMUState GetDirectionalDerivative GetAdjointDerivative \
    EnterConfigurationMode ExitConfigurationMode GetIntervalDecimal GetIntervalFraction GetShiftDecimal GetShiftFraction \
    SetIntervalDecimal SetIntervalFraction SetShiftDecimal SetShiftFraction EvaluateDiscreteStates UpdateDiscreteStates \
    EnterContinuousTimeMode CompletedIntegratorStep SetTime SetContinuousStates GetContinuousStateDerivatives \
    GetEventIndicators GetContinuousStates GetNominalsOfContinuousStates GetNumberOfEventIndicators \
    GetNumberOfContinuousStates EnterStepMode GetOutputDerivatives DoStep ActivateModelPartition";

/// Functions of FMI 2.0 for co-simulation (fmi2Functions.h).
pub const FMI2: &str = "GetTypesPlatform GetVersion SetDebugLogging Instantiate FreeInstance SetupExperiment \
    EnterInitializationMode ExitInitializationMode Terminate Reset GetReal GetInteger GetBoolean GetString SetReal SetInteger \
    SetBoolean SetString GetFMUstate SetFMUstate FreeFMUstate SerializedFMUstateSize SerializeFMUstate DeSerializeFMUstate \
    GetDirectionalDerivative SetRealInputDerivatives GetRealOutputDerivatives DoStep CancelStep GetStatus GetRealStatus \
    GetIntegerStatus GetBooleanStatus GetStringStatus";

#[test]
fn every_function_of_the_standards_is_there() {
    let library = Library::built();
    for name in FMI3.split_whitespace() {
        library.find(&format!("fmi3{name}"));
    }
    for name in FMI2.split_whitespace() {
        library.find(&format!("fmi2{name}"));
    }
}

type Instantiate = unsafe extern "C" fn(
    *const c_char,
    *const c_char,
    *const c_char,
    bool,
    bool,
    bool,
    bool,
    *const u32,
    usize,
    *mut c_void,
    unsafe extern "C" fn(*mut c_void, c_int, *const c_char, *const c_char),
    *const c_void,
) -> *mut c_void;

pub fn instantiate(library: &Library, token: &str, folder: PathBuf) -> *mut c_void {
    // SAFETY: the type is that of the standard's headers.
    let function: Instantiate = unsafe { std::mem::transmute(library.find("fmi3InstantiateCoSimulation")) };
    let (token, folder) = (CString::new(token).unwrap(), CString::new(folder.display().to_string()).unwrap());
    // SAFETY: texts end in a zero, and nothing is required.
    unsafe {
        function(
            c"one".as_ptr(),
            token.as_ptr(),
            folder.as_ptr(),
            false,
            false,
            false,
            false,
            std::ptr::null(),
            0,
            std::ptr::null_mut(),
            log,
            std::ptr::null(),
        )
    }
}

#[test]
fn a_pendulum_by_its_functions_is_that_of_simulate() {
    let scene = Unpacked::of(&known("flexible_pendulum.toml"));
    let library = Library::built();
    let pendulum = instantiate(&library, &scene.model.token, scene.folder.path().to_path_buf());
    assert!(!pendulum.is_null());
    let enter = function!(
        library,
        "fmi3EnterInitializationMode",
        fn(*mut c_void, bool, f64, f64, bool, f64) -> c_int
    );
    let exit = function!(library, "fmi3ExitInitializationMode", fn(*mut c_void) -> c_int);
    let get =
        function!(library, "fmi3GetFloat64", fn(*mut c_void, *const u32, usize, *mut f64, usize) -> c_int);
    let step = function!(
        library,
        "fmi3DoStep",
        fn(*mut c_void, f64, f64, bool, *mut bool, *mut bool, *mut bool, *mut f64) -> c_int
    );
    let free = function!(library, "fmi3FreeInstance", fn(*mut c_void) -> ());
    let mut rows = Vec::new();
    let read = Scene::read(&known("flexible_pendulum.toml")).unwrap();
    simulate(
        &read,
        None,
        |sample| {
            rows.push(sample.clone());
            Ok(())
        },
        |_| {},
    )
    .unwrap();
    let columns = scene.columns();
    let mut values = vec![0.0; columns.len()];
    // SAFETY: a handle that is not freed yet, and places for as many values as the counts say.
    unsafe {
        assert_eq!(enter(pendulum, false, 0.0, 0.0, false, 0.0), 0);
        assert_eq!(exit(pendulum), 0);
        for (index, row) in rows.iter().take(60).enumerate() {
            assert_eq!(get(pendulum, columns.as_ptr(), columns.len(), values.as_mut_ptr(), values.len()), 0);
            assert_eq!(values, row.values);
            let (mut flags, mut time) = ([true; 3], 0.0);
            let [event, end, early] = &mut flags;
            assert_eq!(step(pendulum, index as f64 * 1e-3, 1e-3, true, event, end, early, &raw mut time), 0);
            assert_eq!((flags, time), ([false; 3], index as f64 * 1e-3 + 1e-3));
        }
        // null pointers are answered, and one freed instance is none
        assert_eq!(get(pendulum, columns.as_ptr(), columns.len(), std::ptr::null_mut(), columns.len()), 3);
        assert_eq!(get(pendulum, columns.as_ptr(), 2, values.as_mut_ptr(), 1), 3);
        assert_eq!(get(std::ptr::null_mut(), columns.as_ptr(), 1, values.as_mut_ptr(), 1), 3);
        free(pendulum);
        free(std::ptr::null_mut());
    }
    let messages = MESSAGES.with_borrow(Clone::clone);
    assert_eq!(
        messages,
        [
            "3: a null pointer was passed where a value is expected",
            "3: 2 variables and 1 values: every variable is one number"
        ]
    );
}

#[test]
fn resources_of_another_model_are_refused() {
    let scene = Unpacked::of(&known("flexible_pendulum.toml"));
    let library = Library::built();
    assert!(instantiate(&library, "another", scene.folder.path().to_path_buf()).is_null());
    assert!(instantiate(&library, &scene.model.token, PathBuf::from("/nowhere")).is_null());
    let messages = MESSAGES.with_borrow(Clone::clone);
    assert!(messages[0].contains("are not those of this model description"), "{messages:?}");
    assert!(messages[1].contains("/nowhere/scene.toml"), "{messages:?}");
}
