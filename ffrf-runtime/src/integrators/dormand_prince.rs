//! The method of Dormand and Prince, order 5(4).

use nalgebra::RealField;

use super::system::{begin, finish, refusal, stage};
use super::{StepError, StepReport, System, Tolerances, VectorSpace};

/// Nodes of the stages.
const NODES: [f64; 7] = [0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0];

/// Weights of earlier stages, for stages two to seven; the last row is the method of order five.
const STAGES: [&[f64]; 6] = [
    &[1.0 / 5.0],
    &[3.0 / 40.0, 9.0 / 40.0],
    &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
    &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
    &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
    &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];

/// Difference of the weights of order five and of the embedded order four.
const ERROR: [f64; 7] =
    [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0];

/// Weights of the stages in the last term of the dense output.
const DENSE: [f64; 7] = [
    -12715105075.0 / 11282082432.0,
    0.0,
    87487479700.0 / 32700410799.0,
    -10690763975.0 / 1880347072.0,
    701980252875.0 / 199316789632.0,
    -1453857185.0 / 822651844.0,
    69997945.0 / 29380423.0,
];

/// One step of the method of Dormand and Prince, order 5, explicit, with the error of the embedded method of order 4.
///
/// Seven evaluations of the accelerations; no allocation, bounded work.
/// Source: J. R. Dormand, P. J. Prince, A family of embedded Runge-Kutta formulae, J. Comp. Appl. Math. 6 (1980) 19-26.
///
/// Units: `time`, `step` s. Errors: see [`StepError`].
pub fn step_dormand_prince<S: System<T>, T: RealField + Copy>(
    system: &S,
    state: &S::State,
    time: T,
    step: T,
) -> Result<(S::State, StepReport<T>), StepError> {
    let Stages { slope, error, .. } = stages(system, state, time, step)?;
    finish(system, time + step, state, &slope, &error, None)
}

/// A try of an error-controlled step.
#[derive(Debug, Clone, PartialEq)]
pub struct ControlledStep<S, T = f64> {
    /// The new state with its report, if the error was within the tolerance.
    pub accepted: Option<(S, StepReport<T>)>,
    /// The step to try next. Units: s.
    pub next_step: T,
}

/// Tries a step of [`step_dormand_prince`]: accepted if its error is within the tolerances, with a proposal what to try
/// next.
///
/// Factors of the step stay between 1/5 and 5, safety 0.9. Source: Hairer, Nørsett, Wanner, Solving Ordinary Differential
/// Equations I, II.4. Errors: see [`StepError`]; a state that is not finite counts as an error that is too large, if nothing is
/// wrong before the step.
pub fn try_dormand_prince<S: System<T>, T: RealField + Copy>(
    system: &S,
    state: &S::State,
    time: T,
    step: T,
    tolerances: &Tolerances<T>,
) -> Result<ControlledStep<S::State, T>, StepError> {
    match stages(system, state, time, step) {
        Ok(stages) => controlled(system, state, time, step, tolerances, &stages),
        Err(error) => shorter(step, error),
    }
}

/// A step that has led nowhere is tried again with a fifth of its size. Errors: something else is wrong.
fn shorter<S, T: RealField + Copy>(step: T, error: StepError) -> Result<ControlledStep<S, T>, StepError> {
    match error {
        StepError::NonFiniteResult { .. } => {
            Ok(ControlledStep { accepted: None, next_step: step * nalgebra::convert(0.2) })
        }
        error => Err(error),
    }
}

/// The way of a step of Dormand and Prince between its ends, of order 4.
///
/// Source: Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I, II.6 and the program DOPRI5.
#[derive(Debug, Clone, PartialEq)]
pub struct DenseOutput<I> {
    /// Terms of the polynomial in the share of the step, nested.
    terms: [I; 4],
}

impl<I> DenseOutput<I> {
    fn new<T: RealField + Copy>(stages: &Stages<I>, step: T) -> Self
    where
        I: VectorSpace<T>,
    {
        let Stages { slope, slopes, .. } = stages;
        let [first, .., last] = slopes;
        // h k_1 - Δy, and Δy - h k_7 - that
        let mut begin = first.clone();
        begin.scale(step);
        begin.add_scaled(-T::one(), slope);
        let mut end = slope.clone();
        end.add_scaled(-step, last);
        end.add_scaled(-T::one(), &begin);
        let mut inner = first.clone();
        inner.scale(T::zero());
        for (weight, slope) in DENSE.iter().zip(slopes) {
            inner.add_scaled(step * nalgebra::convert(*weight), slope);
        }
        Self { terms: [slope.clone(), begin, end, inner] }
    }

    /// The increment from the beginning of the step at a `share` in [0, 1] of it; constraints are not met by it.
    pub fn increment<T: RealField + Copy>(&self, share: T) -> I
    where
        I: VectorSpace<T>,
    {
        let [slope, begin, end, inner] = &self.terms;
        let rest = T::one() - share;
        let mut increment = slope.clone();
        increment.scale(share);
        increment.add_scaled(share * rest, begin);
        increment.add_scaled(share * share * rest, end);
        increment.add_scaled(share * share * rest * rest, inner);
        increment
    }
}

/// A try of a step, and the way between its ends if it is accepted.
type DenseStep<S, I, T> = (ControlledStep<S, T>, Option<DenseOutput<I>>);

/// [`try_dormand_prince`] with the way between both ends of an accepted step, for events and outputs. Errors: as there.
pub fn try_dormand_prince_dense<S: System<T>, T: RealField + Copy>(
    system: &S,
    state: &S::State,
    time: T,
    step: T,
    tolerances: &Tolerances<T>,
) -> Result<DenseStep<S::State, S::Increment, T>, StepError> {
    let stages = match stages(system, state, time, step) {
        Ok(stages) => stages,
        Err(error) => return shorter(step, error).map(|tried| (tried, None)),
    };
    let tried = controlled(system, state, time, step, tolerances, &stages)?;
    let dense = tried.accepted.is_some().then(|| DenseOutput::new(&stages, step));
    Ok((tried, dense))
}

/// Whether a step with these stages is accepted, and what to try next.
fn controlled<S: System<T>, T: RealField + Copy>(
    system: &S,
    state: &S::State,
    time: T,
    step: T,
    tolerances: &Tolerances<T>,
    stages: &Stages<S::Increment>,
) -> Result<ControlledStep<S::State, T>, StepError> {
    let (fifth, safety, most): (T, T, T) =
        (nalgebra::convert(0.2), nalgebra::convert(0.9), nalgebra::convert(5.0));
    let ratio = system.weighted_error(state, &stages.error, tolerances);
    // not a number counts as far too large
    if !ratio.is_finite() {
        return shorter(step, refusal(system, time, state, false));
    }
    let factor = if ratio > T::zero() { safety * ratio.powf(-fifth) } else { most };
    let next_step = step * factor.max(fifth).min(most);
    if ratio > T::one() {
        return Ok(ControlledStep { accepted: None, next_step: next_step.min(step * safety) });
    }
    match finish(system, time + step, state, &stages.slope, &stages.error, None) {
        Ok(accepted) => Ok(ControlledStep { accepted: Some(accepted), next_step }),
        Err(error) => shorter(step, error),
    }
}

/// What the stages of a step give.
struct Stages<I> {
    /// The increment of order five.
    slope: I,
    /// The estimate of its error.
    error: I,
    /// The rates in each stage; the last is at the end of the step.
    slopes: [I; 7],
}

fn stages<S: System<T>, T: RealField + Copy>(
    system: &S,
    state: &S::State,
    time: T,
    step: T,
) -> Result<Stages<S::Increment>, StepError> {
    let h = begin(system, state, step)?;
    let none = system.no_change(state);
    let mut slopes: [S::Increment; 7] = core::array::from_fn(|_| none.clone());
    let mut increment = none.clone();
    let mut error = none.clone();
    for (index, node) in NODES.iter().enumerate() {
        if let Some(weights) = index.checked_sub(1).and_then(|row| STAGES.get(row)) {
            increment = none.clone();
            for (weight, slope) in weights.iter().zip(&slopes) {
                increment.add_scaled(h * nalgebra::convert(*weight), slope);
            }
        }
        let rates = system.rates(time + h * nalgebra::convert(*node), state, &increment);
        let rates = stage(system, time, state, false, rates)?;
        if let Some(place) = slopes.get_mut(index) {
            *place = rates;
        }
    }
    for (weight, slope) in ERROR.iter().zip(&slopes) {
        error.add_scaled(h * nalgebra::convert(*weight), slope);
    }
    Ok(Stages { slope: increment, error, slopes })
}
