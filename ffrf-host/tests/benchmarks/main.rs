//! Published reference problems of multibody dynamics: their numbers, with their sources, and what this solver says.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

mod iftomm;
mod run;
mod squeezer;
