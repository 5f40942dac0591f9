//! The structure of the workspace as a test: who may import whom, and how files must look.
//!
//! ARCHITECTURE.md states the same law for people; a change there is a change here. One file for each check.
#![allow(clippy::expect_used)] // helpers of tests are tests

mod modules;
mod workspace;

mod circles;
mod citations;
mod files;
mod generator;
mod imports;
mod licences;
mod paths;
mod unsafe_code;
