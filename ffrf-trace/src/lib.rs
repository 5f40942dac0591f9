//! A number that writes down what is computed with it.
//!
//! Everything in the runtime is generic over its number type. Run on [`Traced`] numbers, it computes as ever and leaves a
//! [`Tape`] of every operation: with constants folded, products by zero gone and equal operations met once, this is the same
//! computation without loops, branches, calls and copies. Branches are taken as the numbers of that run take them; each
//! comparison that decided one stands on the tape as a [`Condition`] under which the tape holds.
//!
//! Sums, differences, products, quotients and square roots are rounded as the traced code rounds them, so the tape gives the
//! same bits as the code that it was made of (zeros may differ in their sign). Other functions are computed of constants
//! alone; of anything else they are [missing](Tape::missing), and the tape is not to be used.
//!
//! ```
//! use ffrf_codegen::expression::Symbol;
//! use ffrf_trace::{Traced, record};
//! use nalgebra::ComplexField;
//!
//! let (root, tape) = record(|| {
//!     let x = Traced::input(Symbol::Intermediate("x", 0), 2.0);
//!     let zero = Traced::number(0.0);
//!     if x > zero { (x * x + zero).sqrt() } else { zero }
//! });
//! assert_eq!(root.value(), 2.0);
//! assert_eq!(tape.graph.len(), 4); // x, 0, x x, its root
//! assert_eq!(tape.conditions.len(), 1); // x > 0
//! ```

mod arithmetic;
mod comparison;
mod field;
mod real;
mod register;
mod tape;
#[cfg(test)]
mod tests;
mod traced;

pub use tape::{Call, Condition, Function, Relation, Tape, record};
pub use traced::Traced;
