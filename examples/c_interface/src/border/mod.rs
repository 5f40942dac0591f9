//! The border to C.
//!
//! Callers keep the contract of the headers: pointers lead to what the prototypes say, or are null, which is answered; one
//! object is used by one thread at a time. Nothing here panics; if it did, the program would end, for no panic leaves an
//! `extern "C"` function.

pub mod free_rod;
mod held;
pub mod slider_crank;

pub use held::Status;
