//! Fuzz target `sid`, see `ffrf_fuzz::TARGETS`.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| ffrf_fuzz::run("sid", data).assert_sound());
