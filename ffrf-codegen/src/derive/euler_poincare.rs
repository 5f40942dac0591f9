//! Equations of motion from a kinetic energy E(q, v, ω, q̇) by the Euler-Poincaré equations on SE(3) x R^M.
//!
//! With body-resolved v and ω, P = ∂E/∂v and L = ∂E/∂ω:
//!
//! ```text
//! d/dt P      + ω × P         = AᵀF
//! d/dt L      + ω × L + v × P = τ
//! d/dt ∂E/∂q̇  - ∂E/∂q         = f
//! ```
//!
//! The unknown is not v̇ but the inertial acceleration of the origin α = v̇ + ω × v. After inserting
//! v̇ = α - ω × v every v must cancel; that is a property of E (Galilean invariance, see [`crate::fidelity`])
//! and is proven by test, not assumed here.

use crate::expression::{Expression, Graph, Input, Symbol, Vector, cross, differentiate, dot, sum3};

/// Mass matrix and quadratic velocity vector, derived from an energy by differentiation.
///
/// Unknowns are w = [α; ω̇; q̈]: M(q) w + Q(q, ω, q̇) = generalised force.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EulerPoincare {
    /// Momenta ∂E/∂[v; ω; q̇]. Shape: N. Frame: body.
    pub momentum: Vec<Expression>,
    /// Mass matrix, the second derivatives of E. Shape: N x N, rows. Source: (203), body-resolved.
    pub mass_matrix: Vec<Vec<Expression>>,
    /// Quadratic velocity vector, on the left-hand side. Shape: N. Source: (209), corrected.
    ///
    /// Holds symbols of v that cancel in polynomial form; evaluated, their sum is round-off.
    pub quadratic_velocity: Vec<Expression>,
}

impl EulerPoincare {
    /// Derives the equations of motion of a body with `mode_count` modes from its kinetic energy.
    pub fn new(graph: &mut Graph, energy: Expression, mode_count: usize) -> Self {
        let axes = [0, 1, 2];
        let v: Vector = axes.map(|i| graph.symbol(Input::VELOCITY.symbol(i)));
        let omega: Vector = axes.map(|i| graph.symbol(Input::ANGULAR_VELOCITY.symbol(i)));
        let velocities: Vec<Symbol> = [Input::VELOCITY, Input::ANGULAR_VELOCITY, Input::RATES]
            .into_iter()
            .flat_map(|input| input.symbols(mode_count))
            .collect();

        let momentum: Vec<_> =
            velocities.iter().flat_map(|velocity| differentiate(graph, &[energy], *velocity)).collect();
        // The mass matrix is symmetric: column l is ∂(∂E/∂s)/∂s_l.
        let mass_matrix: Vec<_> =
            velocities.iter().map(|velocity| differentiate(graph, &momentum, *velocity)).collect();

        let omega_cross_v = cross(graph, omega, v);
        let mut quadratic_velocity: Vec<_> = (0..velocities.len())
            .map(|row| {
                let coefficients: [Expression; 3] = axes.map(|i| mass_matrix[i][row]);
                let carried = dot(graph, coefficients, omega_cross_v);
                graph.negate(carried)
            })
            .collect();
        for mu in 0..mode_count {
            let rate = graph.symbol(Input::RATES.symbol(mu));
            let derivatives = differentiate(graph, &momentum, Input::COORDINATES.symbol(mu));
            for (sum, derivative) in quadratic_velocity.iter_mut().zip(derivatives) {
                let product = graph.multiply(derivative, rate);
                *sum = graph.add(*sum, product);
            }
        }
        let linear: Vector = axes.map(|i| momentum[i]);
        let angular: Vector = axes.map(|i| momentum[3 + i]);
        let force = cross(graph, omega, linear);
        let spin = cross(graph, omega, angular);
        let lever = cross(graph, v, linear);
        let moment = sum3(graph, spin, lever);
        for (sum, bracket) in quadratic_velocity.iter_mut().zip(force.into_iter().chain(moment)) {
            *sum = graph.add(*sum, bracket);
        }
        for mu in 0..mode_count {
            for slope in differentiate(graph, &[energy], Input::COORDINATES.symbol(mu)) {
                quadratic_velocity[6 + mu] = graph.subtract(quadratic_velocity[6 + mu], slope);
            }
        }
        Self { momentum, mass_matrix, quadratic_velocity }
    }
}
