//! A mechanism in motion: model, state and time in one place.

use core::fmt;

use nalgebra::RealField;

use super::{Assembly, Constrained, Energy, Momentum};
use crate::integrators::{
    Drift, StepError, StepReport, Tolerances, VectorSpace, step_linearly_implicit, step_rk4,
};

/// A mechanism with its state and its time; what [`FreeBody`](crate::FreeBody) is to one body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mechanism<A: Assembly<T>, T: RealField + Copy = f64> {
    /// Bodies, joints, forces.
    pub model: A,
    /// Where the bodies are and how they move.
    pub state: A::State,
    /// Time of the state. Units: s.
    pub time: T,
}

impl<A: Assembly<T>, T: RealField + Copy> Mechanism<A, T> {
    /// The mechanism in `state` at time zero. The joints may be open: see [`assemble`](Self::assemble).
    pub fn new(model: A, state: A::State) -> Self {
        Self { model, state, time: T::zero() }
    }

    /// Moves the bodies as little as possible to where the joints are met; says how far they were.
    ///
    /// Bounded work: some twenty factorisations. Errors: a joint cannot be met from here; the state is then unchanged.
    pub fn assemble(&mut self) -> Result<Drift<T>, NotAssembled> {
        let tolerance = T::default_epsilon().sqrt();
        let assembled = Constrained(&self.model).assemble(self.time, self.state.clone(), tolerance);
        let (state, drift) = assembled.map_err(|error| NotAssembled {
            joint: match error {
                StepError::ConstraintsNotMet { joint, .. } => self.model.joint_name(joint),
                _ => "",
            },
            error,
        })?;
        self.state = state;
        Ok(drift)
    }

    /// Energy as it is now; that of forces of the user's own is not known. Units: J.
    pub fn energy(&self) -> Energy<T> {
        self.model.energy(&self.state)
    }

    /// Momentum as it is now.
    pub fn momentum(&self) -> Momentum<T> {
        self.model.momentum(&self.state)
    }

    /// How far accelerations by [`Assembly::straight_rates`] are from those of the general equations now: the norm of the
    /// difference over the larger of both norms, over all bodies. Shape: 1. Units: 1.
    ///
    /// Round-off in a state that moves, if the code was made for this mechanism; at rest round-off is compared with itself.
    /// `None` if one of both has no accelerations here.
    pub fn straight_difference(&self) -> Option<T> {
        let Self { model, state, time } = self;
        let none = model.no_change(state);
        let straight = model.straight_rates(*time, state, &none)?;
        let general =
            Constrained(model).evaluate(*time, state.clone(), None, |ports, _| model.collect(ports, &none));
        Some(self.apart(&straight, &general.ok()?))
    }

    /// The same for [`Assembly::straight_implicit_rates`]: the larger difference of the two stages of a
    /// [linearly implicit step](Self::step_linearly_implicit), the second one at the state of the first.
    ///
    /// Shape: 1. Units: 1; `gamma_h` s.
    pub fn straight_implicit_difference(&self, gamma_h: T) -> Option<T> {
        let Self { model, state, time } = self;
        let none = model.no_change(state);
        let of_stage = |subtracted: Option<&A::Increment>| {
            let straight = model.straight_implicit_rates(*time, state, &none, gamma_h, subtracted)?;
            let general =
                Constrained(model).implicit_rates_at(*time, state.clone(), &none, gamma_h, subtracted);
            let general = general.ok()?;
            Some((self.apart(&straight, &general), general))
        };
        let (first, mut twice) = of_stage(None)?;
        twice.scale(T::one() + T::one());
        let (second, _) = of_stage(Some(&twice))?;
        Some(first.max(second))
    }

    /// The norm of the difference of accelerations over the larger of both norms.
    fn apart(&self, straight: &A::Increment, general: &A::Increment) -> T {
        let (straight, general) = (self.model.velocities_only(straight), self.model.velocities_only(general));
        let mut difference = straight.clone();
        difference.add_scaled(-T::one(), &general);
        let ones = Tolerances { absolute: T::one(), relative: T::zero() };
        let [difference, straight, general] = [difference, straight, general]
            .map(|change| self.model.weighted_error(&self.state, &change, &ones));
        let larger = straight.max(general);
        if larger > T::zero() { difference / larger } else { larger }
    }

    /// Advances by one step of any method for systems, for example
    /// `mechanism.step_with(h, step_dormand_prince)`.
    ///
    /// Units: `step` s. Errors: those of the method; state and time are then unchanged.
    pub fn step_with<'m>(
        &'m mut self,
        step: T,
        method: impl FnOnce(&Constrained<'m, A>, &A::State, T, T) -> Result<(A::State, StepReport<T>), StepError>,
    ) -> Result<StepReport<T>, StepError> {
        let Self { model, state, time } = self;
        let (next, report) = method(&Constrained(model), state, *time, step)?;
        *state = next;
        *time += step;
        Ok(report)
    }

    /// Advances by one explicit step of order 4, see [`step_rk4`].
    ///
    /// Units: `step` s. Errors: see [`StepError`]; state and time are then unchanged.
    pub fn step_rk4(&mut self, step: T) -> Result<StepReport<T>, StepError> {
        self.step_with(step, step_rk4)
    }

    /// Advances by one linearly implicit step of order 2, see [`step_linearly_implicit`].
    ///
    /// Units: `step` s. Errors: see [`StepError`]; state and time are then unchanged.
    pub fn step_linearly_implicit(&mut self, step: T) -> Result<StepReport<T>, StepError> {
        self.step_with(step, step_linearly_implicit)
    }
}

/// Why a mechanism could not be assembled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NotAssembled {
    /// The joint that is farthest from being met; empty if it is not a joint's fault.
    pub joint: &'static str,
    /// Its residual, or what else went wrong.
    pub error: StepError,
}

impl fmt::Display for NotAssembled {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.error {
            StepError::ConstraintsNotMet { residual, .. } => write!(
                formatter,
                "the initial state cannot be assembled: joint `{}` is off by {residual:.3e} (m or rad)",
                self.joint
            ),
            other => write!(formatter, "the initial state cannot be assembled: {other}"),
        }
    }
}

impl core::error::Error for NotAssembled {}
