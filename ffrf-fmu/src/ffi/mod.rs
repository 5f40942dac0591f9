//! The border to C: every `unsafe` of the project but that of C interfaces to single mechanisms.
//!
//! Callers keep the contract of the standard: a handle comes from an instantiate function of the same version and was not
//! freed; pointers lead to as many elements as the count beside them says, or are null where nothing is asked for; strings
//! end in a zero; one instance is called by one thread at a time. Null pointers are answered with an error. A panic, which
//! there should be none of, is caught here, reported, and answered with `fatal` from then on.

pub mod fmi2;
pub mod fmi3;
pub mod fmi3_absent;
mod handle;
mod memory;
