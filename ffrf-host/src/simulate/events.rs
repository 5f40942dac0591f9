//! Events: where functions of time and state pass through zero, found between the steps of an error-controlled run.

use ffrf_runtime::{StepError, System, Tolerances, try_dormand_prince_dense};

/// A function of time and state that is watched.
pub type EventFunction<'a, S> = dyn Fn(f64, &S) -> f64 + 'a;

/// A zero that was passed.
#[derive(Debug, Clone, PartialEq)]
pub struct Event<S> {
    /// Which function, counted from zero.
    pub function: usize,
    /// When. Units: s.
    pub time: f64,
    /// Whether the function was negative before.
    pub rising: bool,
    /// The state there, with its constraints met.
    pub state: S,
}

/// What to do after an event.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Then {
    /// Go on as if nothing had been.
    Continue,
    /// End here.
    Stop,
}

/// Where a run ended.
#[derive(Debug, Clone, PartialEq)]
pub struct Ended<S> {
    /// Units: s.
    pub time: f64,
    /// The state there.
    pub state: S,
}

/// Places in a step at which signs are compared: two zeros between two of them are not seen.
const PLACES: u32 = 8;
/// Most steps of the search in one bracket; each at least halves it every second time.
const SEARCHES: usize = 80;
/// Length of the bracket that ends the search, relative to the step.
const BRACKET: f64 = 1e-14;
/// Smallest step, relative to the whole interval.
const SMALLEST_SHARE: f64 = 1e-12;

/// Runs from `start` to `end` (s) by Dormand-Prince with error control, and hands each event to `on_event` in order of time.
///
/// Zeros are located in the dense output, of order 4, and their states brought back to the constraints. A function that is
/// exactly zero at `start` begins with the sign it takes next.
///
/// Errors: see [`StepError`], with the time of the step; a step that would have to be too small is [`StepError::StepSize`].
pub fn run_with_events<S: System<f64>>(
    system: &S,
    state: &S::State,
    [start, end]: [f64; 2],
    tolerances: &Tolerances,
    functions: &[&EventFunction<'_, S::State>],
    mut on_event: impl FnMut(&Event<S::State>) -> Then,
) -> Result<Ended<S::State>, (f64, StepError)> {
    let (mut time, mut state, mut next) = (start, state.clone(), 1e-2 * (end - start));
    let mut signs: Vec<f64> = functions.iter().map(|function| function(time, &state)).collect();
    while time < end {
        let step = next.min(end - time);
        let (tried, dense) = try_dormand_prince_dense(system, &state, time, step, tolerances)
            .map_err(|error| (time, error))?;
        next = tried.next_step;
        let (Some((reached, _)), Some(dense)) = (tried.accepted, dense) else {
            if next.is_nan() || next <= SMALLEST_SHARE * (end - start) {
                return Err((time, StepError::StepSize { found: next }));
            }
            continue;
        };
        let at = |share: f64| system.retract(&state, &dense.increment(share));
        let value = |index: usize, share: f64| functions[index](time + share * step, &at(share));
        let mut found = Vec::new();
        for (index, before) in signs.iter_mut().enumerate() {
            let mut share = 0.0;
            for place in 1..=PLACES {
                let later = f64::from(place) / f64::from(PLACES);
                let now = value(index, later);
                if *before * now < 0.0 {
                    found.push((
                        zero(|share| value(index, share), [share, later], [*before, now]),
                        index,
                        now > 0.0,
                    ));
                }
                if now != 0.0 {
                    *before = now;
                    share = later;
                }
            }
        }
        found.sort_by(|one, other| one.0.total_cmp(&other.0));
        for (share, function, rising) in found {
            let at_zero = time + share * step;
            let (settled, _) = system.settle(at_zero, at(share), None).map_err(|error| (at_zero, error))?;
            let event = Event { function, time: at_zero, rising, state: settled };
            if on_event(&event) == Then::Stop {
                return Ok(Ended { time: event.time, state: event.state });
            }
        }
        time = if step < end - time { time + step } else { end };
        state = reached;
    }
    Ok(Ended { time, state })
}

/// A zero in a bracket with values of different signs: regula falsi with the Illinois rule, bisected where it is slow.
///
/// Source: Dowell, Jarratt, A modified regula falsi method for computing the root of an equation, BIT 11 (1971) 168-174.
pub(super) fn zero(
    value: impl Fn(f64) -> f64,
    [mut low, mut high]: [f64; 2],
    [mut at_low, mut at_high]: [f64; 2],
) -> f64 {
    for search in 0..SEARCHES {
        if high - low <= BRACKET {
            break;
        }
        let straight = high - at_high * (high - low) / (at_high - at_low);
        let inside = straight > low && straight < high && search % 3 != 2;
        let middle = if inside { straight } else { 0.5 * (low + high) };
        let now = value(middle);
        if now == 0.0 {
            return middle;
        }
        if now * at_high < 0.0 {
            (low, at_low) = (high, at_high);
        } else {
            at_low *= 0.5;
        }
        (high, at_high) = (middle, now);
        if low > high {
            (low, high) = (high, low);
            (at_low, at_high) = (at_high, at_low);
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn zeros_are_found_to_round_off() {
        for root in [0.1, 0.5, 0.912_345_678_9] {
            let found = zero(|x| (x - root) * (1.0 + x * x), [0.0, 1.0], [-root, (1.0 - root) * 2.0]);
            assert!((found - root).abs() < 1e-13, "{found} {root}");
            // flat and steep
            let flat = |x: f64| (x - root).powi(3);
            let found = zero(flat, [0.0, 1.0], [flat(0.0), flat(1.0)]);
            assert!((found - root).abs() < 1e-6, "{found} {root}");
        }
    }
}
