//! FMUs' sources in C, compiled into libraries, and an instance of one.
#![allow(unsafe_code)] // the other side of the border

use std::ffi::{c_int, c_void};
use std::process::Command;

use ffrf_fmu::description::Fmi;
use ffrf_test_kit::c_compilers::{COMPILERS, FLAGS};

use crate::library::{Library, MESSAGES, function, instantiate};
use crate::scenes::Unpacked;

/// An instance in C, FMI 3.0.
pub struct InC {
    pub library: Library,
    pub instance: *mut c_void,
}

/// The libraries of a scene, one by each compiler that is there.
pub fn compiled(scene: &Unpacked, fmi: Fmi) -> Vec<(&'static str, Library, String)> {
    compiled_with(scene, fmi, &[])
}

/// The same with more options.
pub fn compiled_with(scene: &Unpacked, fmi: Fmi, options: &[&str]) -> Vec<(&'static str, Library, String)> {
    let sources = scene.model.c_sources(fmi, "part").unwrap();
    assert_eq!(sources, scene.model.c_sources(fmi, "part").unwrap());
    let folder = tempfile::tempdir().unwrap().keep();
    for (name, text) in &sources.files {
        std::fs::write(folder.join(name), text).unwrap();
    }
    let names: Vec<&str> =
        sources.files.iter().take(sources.compiled).map(|(name, _)| name.as_str()).collect();
    let mut libraries = Vec::new();
    for compiler in COMPILERS {
        if Command::new(compiler).arg("--version").output().is_err() {
            eprintln!("SKIPPED: no {compiler} here");
            continue;
        }
        let binary = format!("{compiler}.so");
        let run = Command::new(compiler)
            .args(FLAGS)
            .args(["-fPIC", "-shared"])
            .args(options)
            .args(&names)
            .args(["-lm", "-o", &binary])
            .current_dir(&folder)
            .output()
            .unwrap();
        assert!(run.status.success(), "{compiler}: {}", String::from_utf8_lossy(&run.stderr));
        libraries.push((compiler, Library::open(&folder.join(binary)), sources.token.clone()));
    }
    std::fs::remove_dir_all(folder).unwrap();
    libraries
}

impl InC {
    pub fn new(library: Library, token: &str) -> Self {
        let instance = instantiate(&library, token, "/nowhere".into());
        assert!(!instance.is_null());
        Self { library, instance }
    }

    pub fn begun(library: Library, token: &str) -> Self {
        let one = Self::new(library, token);
        assert_eq!((one.enter(0.0), one.exit()), (0, 0));
        one
    }

    pub fn enter(&self, start: f64) -> c_int {
        let enter = function!(
            self.library,
            "fmi3EnterInitializationMode",
            fn(*mut c_void, bool, f64, f64, bool, f64) -> c_int
        );
        // SAFETY: an instance that is not freed.
        unsafe { enter(self.instance, false, 0.0, start, false, 0.0) }
    }

    pub fn exit(&self) -> c_int {
        let exit = function!(self.library, "fmi3ExitInitializationMode", fn(*mut c_void) -> c_int);
        // SAFETY: an instance that is not freed.
        unsafe { exit(self.instance) }
    }

    pub fn get(&self, references: &[u32]) -> Vec<f64> {
        let get = function!(
            self.library,
            "fmi3GetFloat64",
            fn(*mut c_void, *const u32, usize, *mut f64, usize) -> c_int
        );
        let mut values = vec![f64::NAN; references.len()];
        // SAFETY: an instance that is not freed, and as many places as are said.
        let status = unsafe {
            get(self.instance, references.as_ptr(), references.len(), values.as_mut_ptr(), values.len())
        };
        assert_eq!(status, 0, "{:?}", MESSAGES.take());
        values
    }

    pub fn set(&self, reference: u32, value: f64) -> c_int {
        let set = function!(
            self.library,
            "fmi3SetFloat64",
            fn(*mut c_void, *const u32, usize, *const f64, usize) -> c_int
        );
        // SAFETY: an instance that is not freed, and one value.
        unsafe { set(self.instance, &raw const reference, 1, &raw const value, 1) }
    }

    pub fn step(&self, from: f64, size: f64) -> c_int {
        let step = function!(
            self.library,
            "fmi3DoStep",
            fn(*mut c_void, f64, f64, bool, *mut bool, *mut bool, *mut bool, *mut f64) -> c_int
        );
        let (mut flags, mut time) = ([true; 3], f64::NAN);
        let [event, end, early] = &mut flags;
        // SAFETY: an instance that is not freed, and places for all answers.
        unsafe { step(self.instance, from, size, true, event, end, early, &raw mut time) }
    }

    pub fn bits(&self, references: &[u32]) -> Vec<u64> {
        self.get(references).iter().map(|value| value.to_bits()).collect()
    }

    /// The state as bytes.
    pub fn bytes(&self) -> Vec<u8> {
        let save = function!(self.library, "fmi3GetFMUState", fn(*mut c_void, *mut *mut c_void) -> c_int);
        let size = function!(
            self.library,
            "fmi3SerializedFMUStateSize",
            fn(*mut c_void, *mut c_void, *mut usize) -> c_int
        );
        let write = function!(
            self.library,
            "fmi3SerializeFMUState",
            fn(*mut c_void, *mut c_void, *mut u8, usize) -> c_int
        );
        let free = function!(self.library, "fmi3FreeFMUState", fn(*mut c_void, *mut *mut c_void) -> c_int);
        let (mut state, mut length) = (std::ptr::null_mut(), 0);
        // SAFETY: an instance and a state that are not freed, and as many bytes as are said.
        unsafe {
            assert_eq!(save(self.instance, &raw mut state), 0);
            assert_eq!(size(self.instance, state, &raw mut length), 0);
            let mut bytes = vec![0; length];
            assert_eq!(write(self.instance, state, bytes.as_mut_ptr(), length - 1), 3);
            assert_eq!(write(self.instance, state, bytes.as_mut_ptr(), length), 0);
            assert_eq!(free(self.instance, &raw mut state), 0);
            assert!(state.is_null());
            bytes
        }
    }

    /// Takes up a state from its bytes.
    pub fn take_up(&self, bytes: &[u8]) -> c_int {
        let read = function!(
            self.library,
            "fmi3DeserializeFMUState",
            fn(*mut c_void, *const u8, usize, *mut *mut c_void) -> c_int
        );
        let resume = function!(self.library, "fmi3SetFMUState", fn(*mut c_void, *mut c_void) -> c_int);
        let free = function!(self.library, "fmi3FreeFMUState", fn(*mut c_void, *mut *mut c_void) -> c_int);
        let mut state = std::ptr::null_mut();
        // SAFETY: an instance and a state that are not freed, and as many bytes as are said.
        unsafe {
            let status = read(self.instance, bytes.as_ptr(), bytes.len(), &raw mut state);
            if status != 0 {
                return status;
            }
            let status = resume(self.instance, state);
            assert_eq!(free(self.instance, &raw mut state), 0);
            status
        }
    }
}

impl Drop for InC {
    fn drop(&mut self) {
        let free = function!(self.library, "fmi3FreeInstance", fn(*mut c_void) -> ());
        // SAFETY: it is not freed, and not used any more.
        unsafe { free(self.instance) }
    }
}
