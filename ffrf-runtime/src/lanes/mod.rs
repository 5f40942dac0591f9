//! Kernels for bodies with many modes: constant tables in the layout of vector registers, and loops over them.
//!
//! Straight-line code stops paying when it outgrows the instruction cache. What remains the same for every body
//! is then written once, here, and a generated body supplies its numbers: a [`LaneBody`] in a `static`. Because
//! the tables are constants, what a layout leaves out (`None`, [`ModalMatrix::Identity`]) is left out of the machine
//! code as well.
//!
//! A *lane* is one mode. Modes stand side by side in registers, in groups of four (`G` groups, padded with zero);
//! sums over modes are horizontal sums at the end. The work is in the product q_ν T_νμ, 11 M² multiply-adds:
//! - [`FullTable`]: every T_μν is stored, q_ν is spread over the lanes;
//! - [`HalfTable`]: T_νμ = T_μνᵀ is stored once and used twice, for tables that outgrow the first-level cache.
//!
//! Safe code on every target: the registers are those of the `wide` crate, which falls back to arrays ([`Compiled`]). On
//! hosts the loops are compiled again for AVX2 and for AVX-512, and run so where the processor has it (`on_registers!`).

mod array;
mod body;
mod dynamics;
mod energy;
mod equations;
mod factors;
mod found;
#[cfg(all(feature = "host-simd", target_arch = "x86_64"))]
mod found_lanes;
mod full_table;
mod groups;
mod half_table;
mod mass_matrix;
mod modal_factors;
mod modal_matrix;
mod moment_structure;
mod moments;
mod parameters;
mod prepared;
mod real;
mod registers;
mod rigid;
mod scalar;
mod vector;

pub use crate::on_registers;
pub use array::ArrayLanes;
pub use body::{LaneBody, ModalMatrix};
pub use equations::State;
pub use factors::Factors;
#[cfg(all(feature = "host-simd", target_arch = "x86_64"))]
pub use fearless_simd::{
    Level,
    x86::{Avx2, Avx512},
};
pub use full_table::FullTable;
pub use half_table::HalfTable;
pub use modal_factors::ModalFactors;
pub use moment_structure::{Antisymmetric, Dense, Diagonal3, MomentComponents, MomentStructure, Symmetric};
pub use moments::{MomentTable, Moments, PortableTable};
pub use parameters::{ParameterDiagonal, ParameterMoments, ParameterTables, Parameters, traces};
pub use real::{Real, numbers, reals};
pub use registers::{Compiled, Processor, Registers, Width};
pub use scalar::Scalar;
pub use vector::{Everywhere, Four, HasLanes, Lanes};

/// `force` less the elastic and damping forces `internal` in its modal rows. Shape: N = 6 + M.
#[inline(always)]
pub fn net_force<T: Scalar, const N: usize, const M: usize>(force: &[T; N], internal: &[T; M]) -> [T; N] {
    const { assert!(N == 6 + M) };
    let mut net = *force;
    for (net, internal) in net[6..].iter_mut().zip(internal) {
        *net -= *internal;
    }
    net
}
