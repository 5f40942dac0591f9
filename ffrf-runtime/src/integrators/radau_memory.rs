//! Steps of the Radau IIA methods that begin with what the step before has found.
//!
//! The accelerations of the stages of the step before, as a polynomial through its nodes, are where the sweeps of the next one begin.
//! They are rates of velocities, which are the same in the chart about any state; rates of places are not, and follow from the
//! velocities that the accelerations lead to. Between sweeps the rates are mixed with what the last eight differences of sweeps say,
//! those of steps before included: Anderson's acceleration.
//!
//! A sweep that has changed the end by Δ is followed by a mixture that would move the end by δ and leaves the share ε of Δ
//! unexplained. The error of the end is taken as ‖δ‖ + ε ‖Δ‖, sweeps end when that or ‖Δ‖ is within tolerance.

use nalgebra::RealField;

use super::radau::{RadauIIA, Solving};
use super::secants::{Secants, Swept};
use super::system::{begin, refusal};
use super::{ImplicitSystem, StepError, StepReport, VectorSpace};

/// The largest step, over the one before, to which accelerations are extrapolated.
const LONGEST: f64 = 1.5;
/// Steps whose sizes differ by less, relative to them, count as the same: sizes that are differences of times are rounded.
const ALIKE: f64 = 1e-6;

/// What [`RadauIIA::step_from`] remembers of the steps before: accelerations of `S` stages and differences of eight sweeps.
#[derive(Debug, Clone)]
pub struct RadauMemory<I, const S: usize, T = f64> {
    /// Size of the last step and the accelerations at its stages.
    last: Option<(T, [I; S])>,
    secants: Secants<I, S, T>,
}

impl<I: VectorSpace<T>, const S: usize, T: RealField + Copy> RadauMemory<I, S, T> {
    /// Nothing to remember: before the first step, or after a state was set by hand.
    pub fn new() -> Self {
        Self { last: None, secants: Secants::new() }
    }
}

impl<I: VectorSpace<T>, const S: usize, T: RealField + Copy> Default for RadauMemory<I, S, T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const S: usize, T: RealField + Copy> RadauIIA<S, T> {
    /// One step from `state`, with `memory` of the steps before, which is that of this step too then.
    ///
    /// The same equations and tolerances as those of [`step`](Self::step): only the number of sweeps differs, and what they leave
    /// within tolerance. Where the sweeps do not come to an end, the step is done again by [`step`](Self::step), and the memory is
    /// empty: at most twice [`iterations`](Self::iterations) times `S` evaluations and factorisations. The report counts the sweeps
    /// of both. A step of another size than the one before keeps the accelerations alone, one more than half as long again nothing.
    /// A memory of another motion costs sweeps. No allocation, bounded work.
    ///
    /// Units: `time`, `step` s. Errors: those of [`step`](Self::step); `memory` is empty then.
    pub fn step_from<S2: ImplicitSystem<T>>(
        &self,
        system: &S2,
        memory: &mut RadauMemory<S2::Increment, S, T>,
        state: &S2::State,
        time: T,
        step: T,
    ) -> Result<(S2::State, StepReport<T>), StepError> {
        let h = begin(system, state, step)?;
        let found = self.solve_from(system, memory, state, time, h);
        if found.is_err() {
            *memory = RadauMemory::new();
        }
        let done = match found {
            Ok(done) => return Ok(done),
            Err(StepError::NotConverged { iterations, .. }) => iterations,
            Err(_) => 0,
        };
        let (state, report) = self.step(system, state, time, step)?;
        Ok((state, StepReport { iterations: report.iterations + done, ..report }))
    }

    fn solve_from<S2: ImplicitSystem<T>>(
        &self,
        system: &S2,
        memory: &mut RadauMemory<S2::Increment, S, T>,
        state: &S2::State,
        time: T,
        h: T,
    ) -> Result<(S2::State, StepReport<T>), StepError> {
        let solving = Solving { system, state, time, h, coefficients: self.coefficients };
        let one = T::one();
        let ratio = memory.last.as_ref().map(|(last, _)| h / *last);
        if ratio.is_none_or(|ratio| (ratio - one).abs() > nalgebra::convert(ALIKE)) {
            memory.secants = Secants::new();
        }
        let begun = match (&memory.last, ratio) {
            (Some((_, accelerations)), Some(ratio)) if ratio <= nalgebra::convert(LONGEST) => {
                Some(solving.extrapolated(accelerations, ratio))
            }
            _ => None,
        };
        let is_begun = begun.is_some();
        let mut rates = begun.unwrap_or_else(|| solving.at_rest());
        let mut changes = solving.at_rest();
        let size = |change: &S2::Increment| system.weighted_error(state, change, &self.tolerances);
        let mut before: Option<Swept<S2::Increment, S, T>> = None;
        let mut residual = T::zero();
        for iteration in 1..=self.iterations {
            solving.sweep(&mut rates, &mut changes, iteration == 1 && !is_begun)?;
            let change = solving.at_end(&changes);
            residual = size(&change);
            if !residual.is_finite() {
                return Err(refusal(system, time + h, state, true));
            }
            let mut last = changes.last().cloned().unwrap_or_else(|| system.no_change(state));
            last.scale(h);
            let mut now = memory.secants.swept([change, last], rates.clone());
            if let Some(before) = before.take() {
                memory.secants.add(before, &mut now);
            }
            let end = solving.at_end(&rates);
            let mixture = if residual <= one { None } else { memory.secants.mixed(&now) };
            let left = mixture.as_ref().map_or(residual, |mixture| {
                let mut moved = solving.at_end(&mixture.rates);
                moved.add_scaled(-one, &end);
                size(&moved) + mixture.unexplained * residual
            });
            if residual.min(left) <= one {
                let (state, report) = solving.finish(&rates, &end)?;
                memory.last = Some((h, rates.map(|rates| system.velocities_only(&rates))));
                return Ok((state, StepReport { iterations: iteration, ..report }));
            }
            if let Some(mixture) = mixture {
                rates = mixture.rates;
            }
            before = Some(now);
        }
        Err(StepError::not_converged(self.iterations, residual))
    }
}

impl<S2: ImplicitSystem<T>, const S: usize, T: RealField + Copy> Solving<'_, S2, S, T> {
    /// The rates of the stages whose accelerations are those of the step before, `ratio` times shorter, extrapolated.
    fn extrapolated(&self, accelerations: &[S2::Increment; S], ratio: T) -> [S2::Increment; S] {
        let ahead: [S2::Increment; S] = core::array::from_fn(|index| {
            let node = self.coefficients.nodes.get(index).copied().unwrap_or_default();
            let at = T::one() + ratio * nalgebra::convert(node);
            let mut sum = self.system.no_change(self.state);
            for (node, acceleration) in self.coefficients.nodes.iter().zip(accelerations) {
                let own: T = nalgebra::convert(*node);
                let others = self.coefficients.nodes.iter().filter(|other| *other != node);
                let weight = others.fold(T::one(), |weight, other| {
                    let other: T = nalgebra::convert(*other);
                    weight * (at - other) / (own - other)
                });
                sum.add_scaled(weight, acceleration);
            }
            sum
        });
        let mut rates = ahead.clone();
        // velocities do not depend on places: the first pass has them, the second one the turning of the chart with the places
        for _ in 0..2 {
            let found: [S2::Increment; S] = core::array::from_fn(|index| {
                let row = self.coefficients.stages.get(index).map_or(&[][..], |row| row);
                let mut rate = self.system.place_rates(self.state, &self.combined(row, &rates));
                if let Some(acceleration) = ahead.get(index) {
                    rate.add_scaled(T::one(), acceleration);
                }
                rate
            });
            rates = found;
        }
        rates
    }
}
