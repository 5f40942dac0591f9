//! Analytic Jacobians of the accelerations and of the implicit residual.
//!
//! With x one of q, q̇, ω, v, force, the residual R = M(q) w + Q(q, ω, q̇) + [0; 0; K q + D q̇] - force is
//! differentiated symbolically. The accelerations solve R = 0, so by the implicit function theorem
//! ∂w/∂x = -M⁻¹ ∂R/∂x at constant w: for each column one more solution with the factors that are there already.
//! With run-time invariants and Θ_ff = I that takes a quarter fewer operations than differentiating the solution
//! symbolically (M = 8: 12 221 against 15 859 for q, q̇ and ω together; the accelerations alone are 3 236).

use super::{DeformedBody, Draft, State, forward_dynamics, internal_force, mass_matrix, quadratic_velocity};
use crate::CodegenError;
use crate::body::BodyExpressions;
use crate::expression::{Expression, Input, Symbol, differentiate, substitute};

/// What a Jacobian is taken with respect to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Variable {
    /// Modal coordinates q. M columns.
    Coordinates,
    /// Modal rates q̇. M columns.
    Rates,
    /// Angular velocity ω, body-resolved. 3 columns.
    AngularVelocity,
    /// Velocity v of the frame origin, body-resolved. 3 columns, all zero: the equations are Galilean invariant.
    Velocity,
    /// Generalised force. N = 6 + M columns.
    Force,
}

impl Variable {
    /// Every variable, in the order of the fields of [`Jacobian`].
    pub const ALL: [Self; 5] =
        [Self::Coordinates, Self::Rates, Self::AngularVelocity, Self::Velocity, Self::Force];

    /// The input whose entries it is.
    pub fn input(self) -> Input {
        match self {
            Self::Coordinates => Input::COORDINATES,
            Self::Rates => Input::RATES,
            Self::AngularVelocity => Input::ANGULAR_VELOCITY,
            Self::Velocity => Input::VELOCITY,
            Self::Force => Input::FORCE,
        }
    }

    /// The symbols of its components, one for each column.
    pub fn symbols(self, mode_count: usize) -> Vec<Symbol> {
        self.input().symbols(mode_count).collect()
    }
}

/// A vector of N = 6 + M expressions and its derivatives.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Jacobian {
    /// The accelerations or the residual. Shape: N.
    pub value: Vec<Expression>,
    /// ∂/∂q, columns. Shape: M columns of N.
    pub coordinates: Vec<Vec<Expression>>,
    /// ∂/∂q̇, columns. Shape: M columns of N.
    pub rates: Vec<Vec<Expression>>,
    /// ∂/∂ω, columns. Shape: 3 columns of N.
    pub angular_velocity: Vec<Vec<Expression>>,
    /// ∂/∂v, columns, all zero. Shape: 3 columns of N.
    pub velocity: Vec<Vec<Expression>>,
    /// ∂/∂force, columns: M⁻¹ for the accelerations, -I for the residual. Shape: N columns of N.
    pub force: Vec<Vec<Expression>>,
}

impl Jacobian {
    /// The columns that belong to `variable`.
    pub fn columns(&self, variable: Variable) -> &[Vec<Expression>] {
        match variable {
            Variable::Coordinates => &self.coordinates,
            Variable::Rates => &self.rates,
            Variable::AngularVelocity => &self.angular_velocity,
            Variable::Velocity => &self.velocity,
            Variable::Force => &self.force,
        }
    }

    fn of(value: Vec<Expression>, mut columns: impl FnMut(Variable) -> Vec<Vec<Expression>>) -> Self {
        Self {
            value,
            coordinates: columns(Variable::Coordinates),
            rates: columns(Variable::Rates),
            angular_velocity: columns(Variable::AngularVelocity),
            velocity: columns(Variable::Velocity),
            force: columns(Variable::Force),
        }
    }

    /// The residual R(q, ω, q̇, w, force) and its derivatives at constant w.
    ///
    /// w are the symbols [`Input::ACCELERATION`]; ∂R/∂w is the mass matrix.
    pub fn of_residual(graph: &mut Draft, body: &BodyExpressions) -> Self {
        let mode_count = body.mode_count();
        let state = State::symbolic(graph, mode_count);
        let deformed = DeformedBody::new(graph, body, &state);
        let quadratic = quadratic_velocity(graph, body, &state, &deformed);
        residual(graph, body, &state, &deformed, &quadratic)
    }

    /// The accelerations w(q, ω, q̇, force) and their derivatives.
    ///
    /// Errors: see [`forward_dynamics`].
    pub fn of_accelerations(graph: &mut Draft, body: &BodyExpressions) -> Result<Self, CodegenError> {
        let mode_count = body.mode_count();
        let state = State::symbolic(graph, mode_count);
        let deformed = DeformedBody::new(graph, body, &state);
        let quadratic = quadratic_velocity(graph, body, &state, &deformed);
        let acceleration = forward_dynamics(graph, body, &state, &deformed, &quadratic)?;
        let residual = residual(graph, body, &state, &deformed, &quadratic);

        // A body without internal forces whose quadratic velocity vector is zero: w = M⁻¹ force.
        let zero = graph.zero();
        let mut inertia_only = body.clone();
        for row in inertia_only.stiffness.iter_mut().chain(&mut inertia_only.damping) {
            row.fill(zero);
        }
        let nothing = vec![zero; 6 + mode_count];
        let mut failure = None;
        let mut solution = |graph: &mut Draft, right_hand_side: Vec<Expression>| {
            let state = State { force: right_hand_side, ..state.clone() };
            let solved = forward_dynamics(graph, &inertia_only, &state, &deformed, &nothing);
            solved.unwrap_or_else(|error| {
                failure = Some(error);
                nothing.clone()
            })
        };
        let jacobian = graph.within_section("Derivatives of the accelerations", |graph| {
            Self::of(acceleration.clone(), |variable| {
                let columns = residual.columns(variable).iter();
                columns
                    .map(|column| {
                        let column = substitute(graph, column, |symbol| match symbol {
                            Symbol::Input(Input::ACCELERATION, row) => acceleration.get(row).copied(),
                            _ => None,
                        });
                        let negative = column.into_iter().map(|entry| graph.negate(entry)).collect();
                        solution(graph, negative)
                    })
                    .collect()
            })
        });
        failure.map_or(Ok(jacobian), Err)
    }
}

/// R = M w + Q + [0; 0; K q + D q̇] - force with its derivatives.
fn residual(
    graph: &mut Draft,
    body: &BodyExpressions,
    state: &State,
    deformed: &DeformedBody,
    quadratic: &[Expression],
) -> Jacobian {
    let mode_count = body.mode_count();
    let columns = mass_matrix(graph, body, deformed);
    graph.section("Residual M w + Q + K q + D q̇ - force");
    let internal = internal_force(graph, body, state);
    let acceleration: Vec<_> =
        Input::ACCELERATION.symbols(mode_count).map(|symbol| graph.symbol(symbol)).collect();
    let mut value = Vec::with_capacity(6 + mode_count);
    for row in 0..6 + mode_count {
        let start = graph.subtract(quadratic[row], state.force[row]);
        let start = if row < 6 { start } else { graph.add(start, internal[row - 6]) };
        let terms = columns.iter().zip(&acceleration).map(|(column, &w)| (column[row], w));
        value.push(graph.sum_of_products(start, terms));
    }
    graph.section("Derivatives of the residual");
    Jacobian::of(value.clone(), |variable| {
        let symbols = variable.symbols(mode_count).into_iter();
        symbols.map(|symbol| differentiate(graph, &value, symbol)).collect()
    })
}
