//! The state of a body: the inputs of its kernels.

use crate::expression::{Expression, Graph, Input, Vector};

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
        let mut list = |input: Input| -> Vec<Expression> {
            input.symbols(mode_count).map(|symbol| graph.symbol(symbol)).collect()
        };
        let [q, q_dot, force] = [Input::COORDINATES, Input::RATES, Input::FORCE].map(&mut list);
        let mut vector = |input: Input| [0, 1, 2].map(|i| graph.symbol(input.symbol(i)));
        Self {
            q,
            q_dot,
            omega: vector(Input::ANGULAR_VELOCITY),
            velocity: vector(Input::VELOCITY),
            force,
            gravity: vector(Input::GRAVITY),
        }
    }
}
