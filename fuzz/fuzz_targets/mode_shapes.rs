//! Fuzz target `mode_shapes`, see `ffrf_fuzz::TARGETS`.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| ffrf_fuzz::run("mode_shapes", data).assert_sound());
