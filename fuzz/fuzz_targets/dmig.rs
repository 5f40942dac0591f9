//! Fuzz target `dmig`, see `ffrf_fuzz::TARGETS`.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| ffrf_fuzz::run("dmig", data).assert_sound());
