//! The energy itself: that of one mass point, hence, the energy being linear in the invariants, of every body.

use ffrf_codegen::body::RawInertia;
use ffrf_codegen::derive::KineticEnergy;
use ffrf_codegen::expression::{Expression, Graph, Input, Symbol, cross, dot, sum3};
use ffrf_codegen::fidelity::Fidelity;
use ffrf_codegen::invariants::Invariant;
use ffrf_codegen::polynomial::polynomials_of;

/// Invariants of a point of mass m at x with mode shapes φ_μ: all moments are products of these.
fn mass_point(graph: &mut Graph, x: [Expression; 3], shapes: &[[Expression; 3]]) -> RawInertia {
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
    let modal_mass = mode_mode_moment
        .iter()
        .map(|row| row.iter().map(|t| graph.sum([t[0][0], t[1][1], t[2][2]])).collect())
        .collect();
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
        let inertia = mass_point(&mut graph, x, &shapes);
        let energy = KineticEnergy::new(&mut graph, &inertia).truncated(&mut graph, &Fidelity::Full);

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
