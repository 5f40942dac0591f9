//! The energy itself: that of one mass point, hence, the energy being linear in the invariants, of every body.

use ffrf_codegen::body::RawInertia;
use ffrf_codegen::derive::KineticEnergy;
use ffrf_codegen::expression::{Expression, Graph, Input, Symbol, cross, dot, sum3};
use ffrf_codegen::fidelity::Fidelity;
use ffrf_codegen::invariants::Invariant;
use ffrf_codegen::polynomial::polynomials_of;

/// Invariants of a point of mass m at x with mode shapes φ_μ and displacements ½ q_μ q_ν g_μν of second order: all moments are
/// products of these, the stress stiffness of a load by the work -load · g_μν that it does.
fn mass_point(
    graph: &mut Graph,
    x: [Expression; 3],
    shapes: &[[Expression; 3]],
    second: &[Vec<[Expression; 3]>],
) -> RawInertia {
    let mass = graph.symbol(Invariant::Mass.at([]));
    let mut moment = |a: [Expression; 3], b: [Expression; 3]| {
        a.map(|left| {
            b.map(|right| {
                let product = graph.multiply(left, right);
                graph.multiply(mass, product)
            })
        })
    };
    let second_moment = moment(x, x);
    let position_mode_moment: Vec<_> = shapes.iter().map(|shape| moment(x, *shape)).collect();
    let mode_mode_moment: Vec<Vec<_>> =
        shapes.iter().map(|a| shapes.iter().map(|b| moment(*a, *b)).collect()).collect();
    let mut linear_load_stiffness: Vec<Vec<_>> =
        second.iter().map(|row| row.iter().map(|g| moment(x, *g)).collect()).collect();
    let modal_mass = mode_mode_moment
        .iter()
        .map(|row| row.iter().map(|t| graph.sum([t[0][0], t[1][1], t[2][2]])).collect())
        .collect();
    for entry in linear_load_stiffness.iter_mut().flatten().flatten().flatten() {
        *entry = graph.negate(*entry);
    }
    let mut uniform_load_stiffness = second.to_vec();
    for entry in uniform_load_stiffness.iter_mut().flatten().flatten() {
        let product = graph.multiply(mass, *entry);
        *entry = graph.negate(product);
    }
    RawInertia {
        mass,
        first_moment: x.map(|component| graph.multiply(mass, component)),
        modal_first_moment: shapes
            .iter()
            .map(|shape| shape.map(|component| graph.multiply(mass, component)))
            .collect(),
        second_moment,
        position_mode_moment,
        mode_mode_moment,
        modal_mass,
        uniform_load_stiffness,
        linear_load_stiffness,
    }
}

#[test]
fn energy_is_that_of_a_mass_point() {
    for mode_count in 0..4 {
        let mut graph = Graph::new();
        let x = [0, 1, 2].map(|i| graph.symbol(Symbol::Intermediate("x", i)));
        let shapes: Vec<_> = (0..mode_count)
            .map(|mu| [0, 1, 2].map(|i| graph.symbol(Symbol::Intermediate("shape", 3 * mu + i))))
            .collect();
        let second = second_order(&mut graph, mode_count);
        let inertia = mass_point(&mut graph, x, &shapes, &second);
        let energy = KineticEnergy::new(&mut graph, &inertia).truncated(&mut graph, &Fidelity::Unstiffened);

        // ½ m |v + ω × (x + q_μ φ_μ) + q̇_μ φ_μ|²
        let mut position = x;
        let mut velocity = [0, 1, 2].map(|i| graph.symbol(Input::VELOCITY.symbol(i)));
        for (mu, shape) in shapes.iter().enumerate() {
            let q = graph.symbol(Input::COORDINATES.symbol(mu));
            let rate = graph.symbol(Input::RATES.symbol(mu));
            let displacement = shape.map(|component| graph.multiply(q, component));
            position = sum3(&mut graph, position, displacement);
            let own = shape.map(|component| graph.multiply(rate, component));
            velocity = sum3(&mut graph, velocity, own);
        }
        let omega = [0, 1, 2].map(|i| graph.symbol(Input::ANGULAR_VELOCITY.symbol(i)));
        let carried = cross(&mut graph, omega, position);
        let velocity = sum3(&mut graph, velocity, carried);
        let square = dot(&mut graph, velocity, velocity);
        let product = graph.multiply(inertia.mass, square);
        let expected = graph.scale(0.5, product);

        let both = polynomials_of(&graph, &[energy, expected]).unwrap();
        assert_eq!(both[0], both[1], "M = {mode_count}");
        assert!(both[0].term_count() > 10);
    }
}

/// g_μν = g_νμ as symbols.
fn second_order(graph: &mut Graph, mode_count: usize) -> Vec<Vec<[Expression; 3]>> {
    let modes = || 0..mode_count;
    let mut symbol = |mu: usize, nu: usize, i: usize| {
        let pair = mu.min(nu) * mode_count + mu.max(nu);
        graph.symbol(Symbol::Intermediate("second", 3 * pair + i))
    };
    modes().map(|mu| modes().map(|nu| [0, 1, 2].map(|i| symbol(mu, nu, i))).collect()).collect()
}

/// With the displacement s = ½ q_μ q_ν g_μν of second order, the point has the energy ½ m |u + ω × s + ṡ|² where u is the velocity
/// without it. Of what s adds, the terms of second order in q and q̇ are m (v + ω × x) · (ω × s + ṡ).
#[test]
fn stiffening_is_the_energy_of_displacements_of_second_order() {
    for mode_count in 0..4 {
        let mut graph = Graph::new();
        let x = [0, 1, 2].map(|i| graph.symbol(Symbol::Intermediate("x", i)));
        let shapes: Vec<_> = (0..mode_count)
            .map(|mu| [0, 1, 2].map(|i| graph.symbol(Symbol::Intermediate("shape", 3 * mu + i))))
            .collect();
        let second = second_order(&mut graph, mode_count);
        let inertia = mass_point(&mut graph, x, &shapes, &second);
        let energy = KineticEnergy::new(&mut graph, &inertia);
        let [full, without] =
            [Fidelity::Full, Fidelity::Unstiffened].map(|fidelity| energy.truncated(&mut graph, &fidelity));
        let found = graph.subtract(full, without);

        let zero = graph.zero();
        let (mut displacement, mut rate) = ([zero; 3], [zero; 3]);
        for (mu, row) in second.iter().enumerate() {
            for (nu, shape) in row.iter().enumerate() {
                let [q_mu, q_nu] = [mu, nu].map(|k| graph.symbol(Input::COORDINATES.symbol(k)));
                let q_dot = graph.symbol(Input::RATES.symbol(nu));
                let product = graph.multiply(q_mu, q_nu);
                let half = graph.scale(0.5, product);
                let part = shape.map(|component| graph.multiply(half, component));
                displacement = sum3(&mut graph, displacement, part);
                let product = graph.multiply(q_mu, q_dot);
                let part = shape.map(|component| graph.multiply(product, component));
                rate = sum3(&mut graph, rate, part);
            }
        }
        let omega = [0, 1, 2].map(|i| graph.symbol(Input::ANGULAR_VELOCITY.symbol(i)));
        let velocity = [0, 1, 2].map(|i| graph.symbol(Input::VELOCITY.symbol(i)));
        let carried = cross(&mut graph, omega, x);
        let rigid = sum3(&mut graph, velocity, carried);
        let turned = cross(&mut graph, omega, displacement);
        let added = sum3(&mut graph, turned, rate);
        let product = dot(&mut graph, rigid, added);
        let expected = graph.multiply(inertia.mass, product);
        let both = polynomials_of(&graph, &[found, expected]).unwrap();
        assert_eq!(both[0], both[1], "M = {mode_count}");
        assert!(mode_count == 0 || both[0].term_count() > 10);
    }
}
