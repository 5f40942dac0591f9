//! The command as a user runs it: one file for each way to use it, in a folder of its own (`workbench`).

mod bad_input;
mod doors;
mod exports;
mod inspect;
mod linearise;
mod outputs;
mod program;
mod reference_cases;
mod simulate;
mod simulate_outputs;
mod tradeoff;
mod view;
mod workbench;
mod workflow;
