//! From finite-element files to numbers, the whole way that a user goes.

mod conrod;
mod reference_bodies;
