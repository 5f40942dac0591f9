//! Fuzz target `op4`, see `ffrf_fuzz::TARGETS`.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| ffrf_fuzz::run("op4", data).assert_sound());
