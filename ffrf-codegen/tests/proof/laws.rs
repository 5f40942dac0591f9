//! Laws that the derived equations obey at every fidelity: power balance, Galilean invariance, symmetry.

use std::collections::BTreeSet;

use ffrf_codegen::body::RawInertia;
use ffrf_codegen::derive::{EulerPoincare, KineticEnergy};
use ffrf_codegen::expression::{Expression, Graph, Input, Symbol, cross, differentiate, dot, subtract3};
use ffrf_codegen::fidelity::{EnergyTerm, Fidelity};
use ffrf_codegen::polynomial::{Polynomial, polynomials_of};

use ffrf_test_kit::proof::compare::Equations;

/// The named levels, every list of inertial terms with all terms of stiffening or none, and every list of those of stiffening with
/// all inertial terms or none.
///
/// The equations are linear in the energy: what holds for these lists holds for their sums and differences, which are all others.
pub fn all_fidelities() -> Vec<Fidelity> {
    let optional = EnergyTerm::ALL.into_iter().filter(|term| !term.is_always_kept());
    let (stiffening, inertial): (Vec<_>, Vec<_>) = optional.partition(|term| term.is_stiffening());
    let mut fidelities = Fidelity::LEVELS.to_vec();
    for (varied, other) in [(&inertial, &stiffening), (&stiffening, &inertial)] {
        for bits in 0..1_usize << varied.len() {
            let kept = varied.iter().enumerate().filter(|(index, _)| bits >> index & 1 == 1);
            let kept: BTreeSet<_> = kept.map(|(_, term)| *term).collect();
            let with_all = kept.iter().chain(other).copied().collect();
            fidelities.extend([Fidelity::Terms(kept), Fidelity::Terms(with_all)]);
        }
    }
    fidelities
}

/// Σ_k s_k (M w + Q)_k - dE/dt, which is zero if the equations conserve `energy`.
///
/// The accelerations w are symbols of their own, so that the identity holds for every motion.
pub fn power_defect(
    graph: &mut Graph,
    energy: Expression,
    mass_matrix: &[Vec<Expression>],
    quadratic_velocity: &[Expression],
) -> Polynomial<Symbol> {
    let size = quadratic_velocity.len();
    let acceleration: Vec<_> = (0..size).map(|k| graph.symbol(Input::ACCELERATION.symbol(k))).collect();
    let v = [0, 1, 2].map(|i| graph.symbol(Input::VELOCITY.symbol(i)));
    let omega = [0, 1, 2].map(|i| graph.symbol(Input::ANGULAR_VELOCITY.symbol(i)));
    let symbols = velocity_symbols(size - 6);

    let mut power = graph.zero();
    for row in 0..size {
        let terms = mass_matrix[row].iter().copied().zip(acceleration.iter().copied());
        let force = graph.sum_of_products(quadratic_velocity[row], terms);
        let velocity = graph.symbol(symbols[row]);
        let product = graph.multiply(velocity, force);
        power = graph.add(power, product);
    }
    // dE/dt by the chain rule, with v̇ = α - ω × v
    let omega_cross_v = cross(graph, omega, v);
    let v_dot = subtract3(graph, [acceleration[0], acceleration[1], acceleration[2]], omega_cross_v);
    for (row, symbol) in symbols.iter().enumerate() {
        let slope = differentiate(graph, &[energy], *symbol)[0];
        let rate = if row < 3 { v_dot[row] } else { acceleration[row] };
        let product = graph.multiply(slope, rate);
        power = graph.subtract(power, product);
    }
    for mu in 0..size - 6 {
        let slope = differentiate(graph, &[energy], Input::COORDINATES.symbol(mu))[0];
        let rate = graph.symbol(Input::RATES.symbol(mu));
        let product = graph.multiply(slope, rate);
        power = graph.subtract(power, product);
    }
    polynomials_of(graph, &[power]).unwrap().remove(0)
}

fn velocity_symbols(mode_count: usize) -> Vec<Symbol> {
    let velocities = [Input::VELOCITY, Input::ANGULAR_VELOCITY, Input::RATES];
    velocities.into_iter().flat_map(|input| input.symbols(mode_count)).collect()
}

#[test]
fn every_fidelity_conserves_its_own_energy() {
    for mode_count in 0..3 {
        for fidelity in all_fidelities() {
            let mut graph = Graph::new();
            let inertia = RawInertia::dense(&mut graph, mode_count);
            let energy = KineticEnergy::new(&mut graph, &inertia).truncated(&mut graph, &fidelity);
            let equations = EulerPoincare::new(&mut graph, energy, mode_count);
            let defect =
                power_defect(&mut graph, energy, &equations.mass_matrix, &equations.quadratic_velocity);
            assert!(defect.is_zero(), "M = {mode_count}, {fidelity:?}: {defect}");
        }
    }
}

#[test]
fn no_fidelity_depends_on_the_velocity_of_the_origin() {
    for mode_count in 0..4 {
        for fidelity in all_fidelities() {
            let mut graph = Graph::new();
            let inertia = RawInertia::dense(&mut graph, mode_count);
            let energy = KineticEnergy::new(&mut graph, &inertia).truncated(&mut graph, &fidelity);
            let derived = EulerPoincare::new(&mut graph, energy, mode_count);
            let equations = Equations::derived(&graph, &derived);
            for (row, entry) in equations.quadratic_velocity.iter().enumerate() {
                let depends = (0..3).any(|i| entry.depends_on(&Input::VELOCITY.symbol(i)));
                assert!(!depends, "M = {mode_count}, {fidelity:?}, row {row}: {entry}");
            }
            for row in 0..6 + mode_count {
                for column in 0..row {
                    assert_eq!(equations.mass_matrix[row][column], equations.mass_matrix[column][row]);
                }
            }
        }
    }
}

/// The reason why `ModalMomentum` is one term: half of it leaves (m B q̇) × v in the rotational equations.
#[test]
fn half_of_the_modal_momentum_would_depend_on_the_velocity_of_the_origin() {
    let mut graph = Graph::new();
    let inertia = RawInertia::dense(&mut graph, 1);
    let energy = KineticEnergy::new(&mut graph, &inertia).truncated(&mut graph, &Fidelity::Full);
    // Take v·(ω × m q b) away and keep m v·B q̇.
    let v = [0, 1, 2].map(|i| graph.symbol(Input::VELOCITY.symbol(i)));
    let omega = [0, 1, 2].map(|i| graph.symbol(Input::ANGULAR_VELOCITY.symbol(i)));
    let q = graph.symbol(Input::COORDINATES.symbol(0));
    let moment = inertia.modal_first_moment[0].map(|component| graph.multiply(q, component));
    let carried = cross(&mut graph, omega, moment);
    let half = dot(&mut graph, v, carried);
    let energy = graph.subtract(energy, half);
    let derived = EulerPoincare::new(&mut graph, energy, 1);
    let equations = Equations::derived(&graph, &derived);
    let leftover: Vec<_> = equations
        .quadratic_velocity
        .iter()
        .map(|entry| {
            (0..3).fold(entry.clone(), |rest, i| {
                rest.substitute(&Input::VELOCITY.symbol(i), &Polynomial::zero()).unwrap()
            })
        })
        .zip(&equations.quadratic_velocity)
        .map(|(without, with)| with.subtract(&without).unwrap().to_string())
        .collect();
    assert_eq!(leftover[0], "0");
    assert_eq!(
        leftover[3],
        "-q_dot0 velocity_z modal_first_moment0_y + q_dot0 velocity_y modal_first_moment0_z"
    );
    assert_ne!(leftover[6], "0");
}
