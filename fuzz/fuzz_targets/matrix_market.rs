//! Fuzz target `matrix_market`, see `ffrf_fuzz::TARGETS`.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| ffrf_fuzz::run("matrix_market", data).assert_sound());
