//! The `ffrf` command.
#![forbid(unsafe_code)]

fn main() {}
