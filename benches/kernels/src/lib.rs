//! Generated bodies for benchmarks and for the tests of the strategies.
#![forbid(unsafe_code)]

pub mod cases;
pub mod columns;
pub mod storage;
pub mod table;
pub mod timing;

include!(concat!(env!("OUT_DIR"), "/bodies.rs"));
