//! The state of a body: the inputs of its kernels.

use crate::expression::{Expression, Graph, Symbol, Vector};

/// The inputs of the kernels as symbols of one graph.
#[derive(Debug, Clone)]
pub struct State {
    /// Modal coordinates q.
    pub q: Vec<Expression>,
    /// Modal rates q̇.
    pub q_dot: Vec<Expression>,
    /// Angular velocity ω, body-resolved.
    pub omega: Vector,
    /// Velocity v of the frame origin, body-resolved.
    pub velocity: Vector,
    /// Generalised force: force, moment, modal forces.
    pub force: Vec<Expression>,
    /// Uniform gravity g, body-resolved.
    pub gravity: Vector,
}

impl State {
    /// The symbols of a body with `mode_count` modes.
    pub fn symbolic(graph: &mut Graph, mode_count: usize) -> Self {
        let mut list = |count: usize, symbol: fn(usize) -> Symbol| -> Vec<Expression> {
            (0..count).map(|k| graph.symbol(symbol(k))).collect()
        };
        let q = list(mode_count, Symbol::Coordinate);
        let q_dot = list(mode_count, Symbol::Rate);
        let force = list(6 + mode_count, Symbol::Force);
        let mut vector = |symbol: fn(usize) -> Symbol| [0, 1, 2].map(|i| graph.symbol(symbol(i)));
        Self {
            q,
            q_dot,
            omega: vector(Symbol::AngularVelocity),
            velocity: vector(Symbol::Velocity),
            force,
            gravity: vector(Symbol::Gravity),
        }
    }
}
