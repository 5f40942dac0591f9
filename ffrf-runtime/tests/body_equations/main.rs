//! The equations of one body in one state: forms, loads, lever arms, and what follows from the deformed quantities.

#[cfg(all(feature = "host-simd", target_arch = "x86_64"))]
mod found_registers;
mod hand_written_bodies;
mod lever_arm;
mod loads;
mod prepared;
mod reference_forms;
