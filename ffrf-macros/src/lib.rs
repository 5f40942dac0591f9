//! The `flexible_body!` macro.
#![forbid(unsafe_code)]
