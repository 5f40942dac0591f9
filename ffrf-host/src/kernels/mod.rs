//! The kernels of generated code, run for a body that was read a moment ago, without compiling that code.

mod generated_kernels;
mod lane_body;
mod lane_kernels;

pub use generated_kernels::GeneratedKernels;
pub use lane_body::Bodies;
pub use lane_kernels::{LARGEST, LaneKernels, lane_kernels};
