//! Simulation of scenes and mechanisms: files, treatments of constraints, events, and the order of every integrator.

mod convergence;
mod events;
mod reference_pendulum;
mod scene_files;
mod soft_rows;
mod sweeps;
mod term_bounds;
mod tradeoff;
mod treatments;
