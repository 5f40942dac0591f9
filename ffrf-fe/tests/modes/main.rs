//! Modes and reduction: reference bodies, two solvers against each other, and structures with known frequencies.

mod reference;
mod reference_bodies;

mod tolerances;
