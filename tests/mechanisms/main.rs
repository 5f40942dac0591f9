//! Mechanisms that `mechanism!` composes, at work.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

mod pendulum;
