//! What the user asks of the mode solver, and what it hands back.

use std::fmt;

use super::{ModeBasis, ModeReport};

/// Which eigenmodes to compute, and how.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ModeRequest {
    /// Number of elastic modes wanted, rigid-body modes not counted.
    pub count: usize,
    /// How the part is held.
    pub support: Support,
    /// Which solver; [`Method::Automatic`] chooses by size.
    pub method: Method,
    /// 1 to use one thread only; otherwise solves use two. The result is the same to the bit.
    pub threads: usize,
}

impl ModeRequest {
    /// The lowest `count` elastic modes of the unsupported part.
    pub fn free_free(count: usize) -> Self {
        Self { count, support: Support::FreeFree, method: Method::Automatic, threads: 0 }
    }

    /// The lowest `count` elastic modes with these node rows held fixed.
    pub fn clamped(count: usize, nodes: Vec<usize>) -> Self {
        Self { support: Support::Clamped { nodes }, ..Self::free_free(count) }
    }
}

/// How the part is held while its modes are computed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Support {
    /// Not at all. Boundary conditions of the export still hold.
    FreeFree,
    /// The nodes of these rows do not move.
    Clamped {
        /// Row numbers of the node table.
        nodes: Vec<usize>,
    },
}

/// Which solver computes the modes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Method {
    /// Dense for small problems, or when a large part of all modes is wanted; sparse otherwise.
    #[default]
    Automatic,
    /// Dense reduction to a standard eigenproblem: every mode is found.
    Dense,
    /// Shift-inverted block Lanczos on a sparse Cholesky factor.
    Sparse,
}

/// One step of a long solve, for a progress bar.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// What is being done.
    pub stage: Stage,
    /// How much of it is done.
    pub done: usize,
    /// Out of how much.
    pub total: usize,
}

/// The stages of a solve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Stage {
    /// Fill-reducing ordering and symbolic factorisation.
    Ordering,
    /// Numeric factorisation of K - σ M.
    Factorising,
    /// Eigenpairs: `done` of `total` have converged.
    Iterating,
    /// Counting the eigenvalues below a shift, so that none is missed.
    Counting,
}

impl fmt::Display for Stage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Ordering => "ordering",
            Self::Factorising => "factorising",
            Self::Iterating => "iterating",
            Self::Counting => "counting",
        })
    }
}

/// A mode basis and the account of how it was found.
#[derive(Debug, Clone)]
pub struct ModeSolution {
    /// The modes.
    pub basis: ModeBasis,
    /// Residuals, counts, effective masses.
    pub report: ModeReport,
}
