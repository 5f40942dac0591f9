//! The model file and the body in it: format, checks, derived quantities, and how files are written.

mod check;
mod derived;
mod file;
mod optional_parts;
mod output;
mod sample;
mod stable_step;
