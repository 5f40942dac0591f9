//! Factorisation and solution of a dense matrix as large as all equations of a chain: ten velocities and five rows a link.
//!
//! The numbers are arbitrary, elimination with row pivoting does the same work for all; assembling is not counted.

use std::hint::black_box;

use nalgebra::{DMatrix, DVector};

use crate::{least, report};

const LINK: usize = 15;
/// A dense solve of the longest chain takes a fraction of a second.
const MOST_ROUNDS: usize = 3;

pub fn run(rounds: usize) {
    for links in [1, 2, 4, 8, 16, 32, 64] {
        let size = LINK * links;
        let entry =
            |i: usize, j: usize| ((7 * i + 13 * j) as f64).sin() + if i == j { size as f64 } else { 0.0 };
        let matrix = DMatrix::from_fn(size, size, entry);
        let right = DVector::from_element(size, 1.0);
        let rounds = if links > 8 { rounds.min(MOST_ROUNDS) } else { rounds };
        report("dense", links, least(rounds, || black_box(&matrix).clone().lu().solve(&right)), &[]);
    }
}
