//! Fuzz target `calculix_list`, see `ffrf_fuzz::TARGETS`.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| ffrf_fuzz::run("calculix_list", data).assert_sound());
