//! Interfaces and component modes: against dense algebra, against each other, and on the connecting rod.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "helpers of tests may panic")]

mod conrod;
mod constraint_modes;
mod dense;
mod free_body;
mod free_free;
mod interfaces;
mod parts;
mod tolerances;
mod transfer;
