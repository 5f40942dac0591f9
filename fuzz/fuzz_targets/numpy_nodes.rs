//! Fuzz target `numpy_nodes`, see `ffrf_fuzz::TARGETS`.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| ffrf_fuzz::run("numpy_nodes", data).assert_sound());
