//! Simulation of a scene.
