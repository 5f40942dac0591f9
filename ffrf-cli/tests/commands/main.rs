//! The command as a user runs it: one file for each way to use it, in a folder of its own (`workbench`).

mod assembly;
mod bad_input;
mod convert;
mod doors;
mod exports;
mod fmu;
mod inspect;
mod lacking_terms;
mod linearise;
mod meshes;
mod outputs;
mod plan;
mod program;
mod reference_cases;
mod simulate;
mod simulate_outputs;
mod stiffening;
mod straight_line;
mod tradeoff;
mod view;
mod workbench;
mod workflow;
