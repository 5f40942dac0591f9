//! How generated C is compiled in tests.

/// Every warning that users' projects are likely to ask for is an error; products and sums are rounded each, as in Rust.
pub const FLAGS: [&str; 9] = [
    "-std=c99",
    "-Wall",
    "-Wextra",
    "-Wpedantic",
    "-Wconversion",
    "-Wshadow",
    "-Werror",
    "-O2",
    "-ffp-contract=off",
];

/// The compilers that are tried; each that is there must accept the code.
pub const COMPILERS: [&str; 2] = ["gcc", "clang"];
