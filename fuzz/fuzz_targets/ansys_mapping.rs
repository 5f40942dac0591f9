//! Fuzz target `ansys_mapping`, see `ffrf_fuzz::TARGETS`.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| ffrf_fuzz::run("ansys_mapping", data).assert_sound());
