//! Proofs that the loops over lanes compute the equations of motion, as identities of polynomials.
//!
//! The loops of the runtime are run as they are, on symbols in the place of numbers, over tables that the generator
//! arranges as it does for generated code. What they write down is compared, coefficient by coefficient, with what the
//! Euler-Poincaré equations give from the kinetic energy.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

mod loops;
mod symbolic;

mod accelerations;
mod mutants;
mod polynomials;

use ffrf_codegen::fidelity::Fidelity;
use ffrf_codegen::layout::{Layout, Structure};

/// Layouts of all kinds; each other structure by itself.
fn layouts() -> Vec<Layout> {
    let mut layouts = Vec::new();
    for modal_mass in [Structure::Identity, Structure::Diagonal, Structure::Symmetric] {
        for base in [Layout::GENERAL, Layout::FREE_FREE] {
            for stiffness in [Structure::Zero, Structure::Diagonal, Structure::Symmetric] {
                let base = Layout { modal_mass, stiffness, damping: stiffness, ..base };
                layouts.push(base);
                layouts.push(Layout { first_moment: Structure::Zero, ..base });
                layouts.push(Layout { modal_first_moment: Structure::Zero, ..base });
                layouts.push(Layout { position_mode_moment: Structure::Zero, ..base });
                layouts.push(Layout { position_mode_moment: Structure::Antisymmetric, ..base });
                layouts.push(Layout { mode_mode_moment: Structure::Symmetric, ..base });
            }
        }
    }
    let mut different: Vec<Layout> = Vec::new();
    for layout in layouts {
        if !different.contains(&layout) {
            different.push(layout);
        }
    }
    different
}

/// The named levels.
fn fidelities() -> Vec<Fidelity> {
    Fidelity::LEVELS.to_vec()
}
