//! What runs on every target, bit by bit the same: kernels, a free body and a flexible slider-crank.
//!
//! Contraction is off and float functions come from the `libm` crate on every target, the desktop included.
#![no_std]
#![forbid(unsafe_code)]

pub mod bodies;
mod flight;
mod hash;
mod kernels;
mod motion;
mod slider_crank;

pub use hash::{Bits, Hash};
pub use motion::Motion;

/// Where results go: how often a case was advanced, and the hash of every bit that it had by then.
pub type Sink<'s> = &'s mut dyn FnMut(u32, u64);

/// One case and what it is called.
#[derive(Clone, Copy)]
pub struct Case {
    /// Subject, number of modes, scalar.
    pub name: &'static str,
    /// Advances so often at most and tells the hash after each power of ten.
    pub run: fn(u32, Sink<'_>),
}

/// Every case, the cheap ones first.
pub const CASES: [Case; 19] = [
    Case { name: "kernels_m0_f32", run: kernels::rigid_f32 },
    Case { name: "kernels_m4_f32", run: kernels::four_f32 },
    Case { name: "kernels_m8_f32", run: kernels::eight_f32 },
    Case { name: "kernels_m0_f64", run: kernels::rigid_f64 },
    Case { name: "kernels_m4_f64", run: kernels::four_f64 },
    Case { name: "kernels_m8_f64", run: kernels::eight_f64 },
    Case { name: "free_m0_f32_rk4", run: flight::rigid_f32 },
    Case { name: "free_m4_f32_rk4", run: flight::four_f32 },
    Case { name: "free_m8_f32_rk4", run: flight::eight_f32 },
    Case { name: "free_m0_f64_rk4", run: flight::rigid_f64 },
    Case { name: "free_m4_f64_rk4", run: flight::four_f64 },
    Case { name: "free_m8_f64_rk4", run: flight::eight_f64 },
    Case { name: "free_m4_f32_implicit", run: flight::four_f32_implicit },
    Case { name: "free_m4_f64_implicit", run: flight::four_f64_implicit },
    Case { name: "slider_crank_m4_f32", run: slider_crank::four_f32 },
    Case { name: "slider_crank_m8_f32", run: slider_crank::eight_f32 },
    Case { name: "slider_crank_m4_f64", run: slider_crank::four_f64 },
    Case { name: "slider_crank_m8_f64", run: slider_crank::eight_f64 },
    Case { name: "slider_crank_driven_m4_f64", run: slider_crank::driven_f64 },
];

/// The rod in flight with four modes, by the linearly implicit method at 1 kHz.
pub fn flying_four_f32() -> impl Motion {
    flight::Flight::<bodies::Four32, f32>::thrown(bodies::Four32, true)
}

/// The slider-crank with four modes at 1 kHz.
pub fn slider_crank_four_f32() -> impl Motion {
    slider_crank::four32::Running::stretched()
}
