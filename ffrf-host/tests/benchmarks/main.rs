//! Published reference problems of multibody dynamics: their numbers, with their sources, and what this solver says.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

mod governor;
mod heavy_top;
mod iftomm;
mod pendulum;
mod run;
mod slider_crank;
mod spin_up;
mod squeezer;
