//! Fuzz target `calculix_dof`, see `ffrf_fuzz::TARGETS`.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| ffrf_fuzz::run("calculix_dof", data).assert_sound());
