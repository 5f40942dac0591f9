//! Advances a mechanism by each of our integrators, observes it at equidistant times and takes the time.

use std::time::Instant;

use ffrf::mechanism::{Assembly, Constrained, Mechanism};
use ffrf::{
    GeneralisedAlpha, RadauIIA, RadauMemory, StepError, Tolerances, step_dormand_prince,
    step_linearly_implicit, step_rk4, try_dormand_prince,
};

/// What is observed of a state: points (m).
pub type Observation = Vec<f64>;

/// Steps of error control before a run is given up.
const MOST_TRIES: usize = 100_000_000;

/// What the command line asks for.
pub enum Request {
    /// The initial state.
    Start,
    /// A run; whether the mechanism has its stages, and its projections, in straight-line code.
    Run { method: String, is_straight: bool, step: f64, duration: f64, samples: usize, rounds: usize },
}

/// What the name of a method ends with that runs on the mechanism in straight-line code.
const STRAIGHT: &str = "_straight_line";
/// Methods whose stages are evaluations of accelerations: the others have linearly implicit stages.
const EXPLICIT: [&str; 3] = ["rk4", "dopri5", "dopri5_fixed"];
/// Largest difference of straight-line accelerations from those of the equations, relative to their norm. The dampers of the rotor
/// lose digits in both: their forces are differences of speeds.
const DIFFERENCE: f64 = 1e-9;

impl Request {
    /// From the words after the case.
    pub fn parse(words: &[String]) -> Result<Self, String> {
        let number =
            |word: &String| word.parse::<f64>().map_err(|_| format!("expected a number, found `{word}`"));
        match words {
            [start] if start == "start" => Ok(Self::Start),
            [name, step, duration, samples, rounds] => {
                let method = name.strip_suffix(STRAIGHT).unwrap_or(name);
                let is_straight = method != name;
                Ok(Self::Run {
                    method: method.to_owned(),
                    is_straight,
                    step: number(step)?,
                    duration: number(duration)?,
                    samples: number(samples)? as usize,
                    rounds: number(rounds)? as usize,
                })
            }
            _ => Err("expected `start`, or METHOD STEP DURATION SAMPLES ROUNDS".to_owned()),
        }
    }

    /// Whether the mechanism is to be the one with accelerations in straight-line code.
    pub fn is_straight(&self) -> bool {
        matches!(self, Self::Run { is_straight: true, .. })
    }
}

/// The runs of `request` from `start`, as a line of JSON. For `dopri5` the step is the tolerance, relative to each
/// component and absolute times a thousandth.
pub fn run<A: Assembly<f64> + Copy>(
    start: &Mechanism<A>,
    request: &Request,
    observe: impl Fn(&A, &A::State) -> Observation,
    describe: impl Fn(&A::State) -> String,
) -> Result<String, String> {
    let Request::Run { method, is_straight, step, duration, samples, rounds } = request else {
        return Ok(describe(&start.state));
    };
    let mut seconds = f64::INFINITY;
    let mut points = Vec::new();
    let mut steps = 0;
    for _ in 0..*rounds {
        points.clear();
        let begin = Instant::now();
        steps = simulate(start, method, *step, *duration, *samples, |state| {
            points.push(observe(&start.model, state))
        })
        .map_err(|error| format!("{method} at {step:e}: {error}"))?;
        seconds = seconds.min(begin.elapsed().as_secs_f64());
    }
    if *is_straight {
        check(start, method, *step, *duration, *samples)?;
    }
    Ok(format!("{{\"seconds\": {seconds:e}, \"steps\": {steps}, \"samples\": {points:?}}}"))
}

/// Runs once more and compares straight-line stages with those of the equations at every sample: where the code does not
/// hold, a step takes the equations in silence, and those would have been timed.
fn check<A: Assembly<f64> + Copy>(
    start: &Mechanism<A>,
    method: &str,
    step: f64,
    duration: f64,
    samples: usize,
) -> Result<(), String> {
    let difference = |mechanism: &Mechanism<A>| {
        if EXPLICIT.contains(&method) {
            mechanism.straight_difference()
        } else {
            mechanism.straight_implicit_difference(step / 2.0)
        }
    };
    let mut differences = vec![difference(start)];
    let period = duration / samples as f64;
    simulate(start, method, step, duration, samples, |state| {
        let mechanism = Mechanism {
            model: start.model,
            state: state.clone(),
            time: start.time + differences.len() as f64 * period,
        };
        differences.push(difference(&mechanism));
    })
    .map_err(|error| error.to_string())?;
    match differences.iter().find(|found| found.is_none_or(|difference| difference > DIFFERENCE)) {
        Some(found) => {
            Err(format!("straight-line code of another mechanism, or outside of where it holds: {found:?}"))
        }
        None => Ok(()),
    }
}

/// One run; the number of steps.
fn simulate<A: Assembly<f64>>(
    start: &Mechanism<A>,
    method: &str,
    step: f64,
    duration: f64,
    samples: usize,
    mut sample: impl FnMut(&A::State),
) -> Result<usize, StepError> {
    let model = &start.model;
    let system = Constrained(model);
    let (mut state, mut time) = (start.state.clone(), start.time);
    let period = duration / samples as f64;
    let count = (period / step).round() as usize;
    let mut steps = 0;
    let mut fixed = |one: &mut dyn FnMut(&A::State, f64, f64) -> Result<A::State, StepError>| {
        for number in 1..=samples {
            for _ in 0..count {
                state = one(&state, time, period / count as f64)?;
                time += period / count as f64;
            }
            steps += count;
            time = start.time + number as f64 * period;
            sample(&state);
        }
        Ok(steps)
    };
    match method {
        "rk4" => fixed(&mut |state, time, h| Ok(step_rk4(&system, state, time, h)?.0)),
        "dopri5_fixed" => fixed(&mut |state, time, h| Ok(step_dormand_prince(&system, state, time, h)?.0)),
        "linearly_implicit" => {
            fixed(&mut |state, time, h| Ok(step_linearly_implicit(&system, state, time, h)?.0))
        }
        "generalised_alpha" => {
            let method = GeneralisedAlpha::new();
            let mut memory = method.start(&system, &start.state, start.time, period / count as f64)?;
            fixed(&mut |state, time, h| Ok(method.step(&system, &mut memory, state, time, h)?.0))
        }
        "dopri5" => {
            let tolerances = Tolerances { relative: step, absolute: step * 1e-3 };
            let mut h = period * 1e-3;
            let mut tries = 0;
            for number in 1..=samples {
                let end = start.time + number as f64 * period;
                while end - time > period * 1e-12 {
                    let cut = h.min(end - time);
                    let tried = try_dormand_prince(&system, &state, time, cut, &tolerances)?;
                    // an accepted step that was cut to meet the sample says nothing against longer ones
                    h = if tried.accepted.is_some() && cut < h { h } else { tried.next_step };
                    if let Some((next, _)) = tried.accepted {
                        (state, time) = (next, time + cut);
                    }
                    tries += 1;
                    if tries > MOST_TRIES {
                        return Err(StepError::StepSize { found: h });
                    }
                }
                time = end;
                sample(&state);
            }
            Ok(tries)
        }
        method => {
            // `radau5_TOLERANCE`, `radau7_TOLERANCE`: what may be left of the iteration, relative to each component; with `_remembered`
            // before it, stages begin with what the steps before have found
            let Some((method, tolerance)) = method.rsplit_once('_') else {
                return Err(StepError::StepSize { found: f64::NAN });
            };
            let relative = tolerance.parse().map_err(|_| StepError::StepSize { found: f64::NAN })?;
            let tolerances = Tolerances { relative, absolute: relative * 1e-3 };
            match method {
                "radau5" => {
                    let method = RadauIIA { tolerances, ..RadauIIA::order_five() };
                    fixed(&mut |state, time, h| Ok(method.step(&system, state, time, h)?.0))
                }
                "radau5_remembered" => {
                    let method = RadauIIA { tolerances, ..RadauIIA::order_five() };
                    let mut memory = RadauMemory::new();
                    fixed(&mut |state, time, h| Ok(method.step_from(&system, &mut memory, state, time, h)?.0))
                }
                "radau7_remembered" => {
                    let method = RadauIIA { tolerances, ..RadauIIA::order_seven() };
                    let mut memory = RadauMemory::new();
                    fixed(&mut |state, time, h| Ok(method.step_from(&system, &mut memory, state, time, h)?.0))
                }
                _ => {
                    let method = RadauIIA { tolerances, ..RadauIIA::order_seven() };
                    fixed(&mut |state, time, h| Ok(method.step(&system, state, time, h)?.0))
                }
            }
        }
    }
}
