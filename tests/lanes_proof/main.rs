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
use ffrf_codegen::invariants::{Invariant, Structure};
use ffrf_codegen::layout::Layout;

/// Layouts of all kinds; each other structure by itself.
fn layouts() -> Vec<Layout> {
    let mut layouts = Vec::new();
    for modal_mass in [Structure::Identity, Structure::Diagonal, Structure::Symmetric] {
        for base in [Layout::GENERAL, Layout::FREE_FREE] {
            for stiffness in [Structure::Zero, Structure::Diagonal, Structure::Symmetric] {
                let base = base
                    .with(Invariant::ModalMass, modal_mass)
                    .with(Invariant::Stiffness, stiffness)
                    .with(Invariant::Damping, stiffness);
                layouts.push(base);
                layouts.push(base.with(Invariant::FirstMoment, Structure::Zero));
                layouts.push(base.with(Invariant::ModalFirstMoment, Structure::Zero));
                layouts.push(base.with(Invariant::PositionModeMoment, Structure::Zero));
                layouts.push(base.with(Invariant::PositionModeMoment, Structure::Antisymmetric));
                layouts.push(base.with(Invariant::ModeModeMoment, Structure::Symmetric));
                layouts.push(base.with(Invariant::LinearLoadStiffness, Structure::Dense));
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
