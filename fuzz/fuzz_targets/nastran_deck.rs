//! Fuzz target `nastran_deck`, see `ffrf_fuzz::TARGETS`.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| ffrf_fuzz::run("nastran_deck", data).assert_sound());
