//! Energies, momenta, internal forces and gravity.

use super::structured::moment_sum;
use super::{DeformedBody, Draft, State};
use crate::body::BodyExpressions;
use crate::expression::{Expression, Graph, Vector, cross, dot, sum3, symmetric_times};

/// Kinetic energy E. Units: J. Source: `docs/theory/README.md`, E.
pub fn kinetic_energy(
    graph: &mut Draft,
    body: &BodyExpressions,
    state: &State,
    deformed: &DeformedBody,
) -> Expression {
    graph.section("Twice the energy: v · P + ω · L + q̇ · p");
    let linear = linear_momentum(graph, body, state, deformed);
    let angular = angular_momentum(graph, state, deformed);
    let translation = dot(graph, state.velocity, linear);
    let rotation = dot(graph, state.omega, angular);
    let rigid = graph.add(translation, rotation);
    // Modal momenta p_μ = m b_μ · v + ω · Θ_rf,μ + Θ_ff,μν q̇_ν
    let mut twice = rigid;
    for mu in 0..body.mode_count() {
        let carried = dot(graph, deformed.modal_first_moment[mu], state.velocity);
        let spin = dot(graph, deformed.moments[mu].odd, state.omega);
        let start = graph.add(carried, spin);
        let terms = state.q_dot.iter().enumerate().map(|(nu, &rate)| (body.modal_mass[mu][nu], rate));
        let momentum = graph.sum_of_products(start, terms);
        graph.label(momentum, format!("modal_momentum{mu}"));
        twice = graph.sum_of_products(twice, [(momentum, state.q_dot[mu])]);
    }
    graph.scale(0.5, twice)
}

/// Elastic energy ½ qᵀ K q. Units: J.
pub fn elastic_energy(graph: &mut Draft, body: &BodyExpressions, state: &State) -> Expression {
    graph.section("Elastic energy");
    let zero = graph.zero();
    let mut twice = zero;
    for (mu, row) in body.stiffness.iter().enumerate() {
        let terms = row.iter().copied().zip(state.q.iter().copied());
        let force = graph.sum_of_products(zero, terms);
        twice = graph.sum_of_products(twice, [(force, state.q[mu])]);
    }
    graph.scale(0.5, twice)
}

/// Linear momentum P = m v + ω × m r + m B q̇. Shape: 3. Units: N s. Frame: body.
pub fn linear_momentum(
    graph: &mut Graph,
    body: &BodyExpressions,
    state: &State,
    deformed: &DeformedBody,
) -> Vector {
    let carried = cross(graph, state.omega, deformed.first_moment);
    let moving = [0, 1, 2].map(|i| graph.sum_of_products(carried[i], [(body.mass, state.velocity[i])]));
    moment_sum(graph, &deformed.modal_first_moment, moving, &state.q_dot)
}

/// Angular momentum about the frame origin, L = m r × v + Θ_rr ω + Θ_rf q̇. Shape: 3. Units: N m s. Frame: body.
pub fn angular_momentum(graph: &mut Graph, state: &State, deformed: &DeformedBody) -> Vector {
    let carried = cross(graph, deformed.first_moment, state.velocity);
    let spin = symmetric_times(graph, &deformed.inertia, state.omega);
    let modal = deformed.coupling_times(graph, &state.q_dot);
    let sum = sum3(graph, carried, spin);
    sum3(graph, sum, modal)
}

/// Elastic and damping forces K q + D q̇. Shape: M.
pub fn internal_force(graph: &mut Graph, body: &BodyExpressions, state: &State) -> Vec<Expression> {
    let zero = graph.zero();
    let mut forces = Vec::with_capacity(body.mode_count());
    for (stiffness, damping) in body.stiffness.iter().zip(&body.damping) {
        let elastic = stiffness.iter().copied().zip(state.q.iter().copied());
        let viscous = damping.iter().copied().zip(state.q_dot.iter().copied());
        forces.push(graph.sum_of_products(zero, elastic.chain(viscous)));
    }
    forces
}

/// Generalised force of uniform gravity g: [m g; m r × g; m b_μ · g]. Shape: N. Frame: body.
pub fn gravity_force(
    graph: &mut Draft,
    body: &BodyExpressions,
    state: &State,
    deformed: &DeformedBody,
) -> Vec<Expression> {
    graph.section("Gravity");
    let mut force: Vec<Expression> =
        state.gravity.iter().map(|&component| graph.multiply(body.mass, component)).collect();
    force.extend(cross(graph, deformed.first_moment, state.gravity));
    for moment in &deformed.modal_first_moment {
        force.push(dot(graph, *moment, state.gravity));
    }
    force
}
