//! The equations of a scene, run once on numbers that write down what is computed with them.

use ffrf_codegen::ArrayFunction;
use ffrf_codegen::expression::Expression;
use ffrf_runtime::mechanism::{Assembly, Constrained, Treatment};
use ffrf_runtime::{State, StepError, System};
use ffrf_trace::{Tape, Traced, record};

use super::Motions;
use super::StraightLineError;
use super::arguments::Arguments;
use crate::scene::Scene;
use crate::{HostMechanism, HostModal};

/// The scene's mechanism on numbers that write down what is computed with them.
pub(super) type TracedSystem<'a> = Constrained<'a, HostMechanism<Traced>>;
/// The states of all its bodies.
pub(super) type TracedStates = Vec<State<HostModal<Traced>, Traced>>;

/// How far the state at which the equations are run is from the initial one, in the units of each number: at rest, stretched or
/// parallel to an axis, comparisons come out as they do nowhere else. The first one at which there are accelerations is taken:
/// bodies are not what they are where they are deformed without measure.
const OFF: [f64; 3] = [1e-3, 1e-6, 1e-9];

/// The constrained accelerations of a scene as a function of state and drives, for explicit integrators.
///
/// ```text
/// fn NAME(state: &[f64; S], drives: &[[f64; 3]; D], accelerations: &mut [f64; V]) -> bool
/// ```
///
/// `state`: of each body position (inertial), orientation as i, j, k, w, modal coordinates, velocity (inertial), angular
/// velocity (body) and modal rates. `drives`: value, rate and acceleration for each joint, zeros, and behind it for its drive.
/// `accelerations`: of each body those of the frame origin (inertial), angular ones (body) and modal ones. `false`: a
/// comparison came out otherwise than near the initial state, or something is not zero that does not move by `motions`; the
/// results are not to be used.
///
/// Errors: see [`StraightLineError`].
pub fn accelerations(
    scene: &Scene,
    motions: &Motions,
    name: &str,
) -> Result<ArrayFunction, StraightLineError> {
    check(scene)?;
    let arguments = Arguments::of(scene, motions);
    let (results, tape) = trace_accelerations(scene, &arguments)?;
    let documentation = [
        "Constrained accelerations of the whole mechanism, in straight-line code.",
        "",
        "`state`: for each body position 3 (inertial), orientation 4 (i, j, k, w), modal coordinates, velocity 3 (inertial),",
        "angular velocity 3 (body), modal rates. `drives`: for each joint zeros, and behind it value, rate, acceleration of its drive.",
        "`accelerations`: for each body of the frame origin 3 (inertial), angular 3 (body), modal. `false`: the state is one in",
        "which other branches of the equations hold, and the results are not to be used.",
        "",
    ];
    Ok(ArrayFunction {
        name: name.to_owned(),
        documentation: arguments.documentation(&documentation, &[("state", 13, 2), ("accelerations", 6, 1)]),
        inputs: vec![arguments.state, arguments.drives],
        output: "accelerations",
        graph: tape.graph,
        calls: tape.calls,
        results,
        conditions: tape.conditions,
    })
}

/// The accelerations of explicit stages.
pub(super) fn trace_accelerations(
    scene: &Scene,
    arguments: &Arguments,
) -> Result<(Vec<Expression>, Tape), StraightLineError> {
    trace(scene, arguments, |system, state, _| {
        let rates = system.rates(Traced::number(0.0), state, &system.no_change(state))?;
        Ok(Arguments::results(&rates))
    })
}

/// Runs the equations: the `results` in a state that is so far off the initial one.
pub(super) fn trace(
    scene: &Scene,
    arguments: &Arguments,
    results: impl Fn(&TracedSystem<'_>, &TracedStates, f64) -> Result<Vec<Traced>, StepError>,
) -> Result<(Vec<Expression>, Tape), StraightLineError> {
    let at = |off: f64| {
        let (found, tape) = record(|| {
            let drives = arguments.drive_values(scene, off);
            let mechanism: HostMechanism<Traced> = scene.mechanism.cast().with_drive_values(drives);
            let state = arguments.state(scene, off);
            let numbers = results(&Constrained(&mechanism), &state, off)?;
            Ok(numbers.into_iter().map(Traced::expression).collect())
        });
        if !tape.missing.is_empty() {
            return Err(StraightLineError::Functions { functions: tape.missing.join(", ") });
        }
        Ok((found.map_err(StraightLineError::Accelerations)?, tape))
    };
    let [first, second, third] = OFF;
    at(first).or_else(|_| at(second)).or_else(|_| at(third))
}

/// Refuses what changes while code stays as it is.
pub(super) fn check(scene: &Scene) -> Result<(), StraightLineError> {
    let unknown = |name: &String| Err(StraightLineError::Unknown { what: format!("forces.{name}") });
    if let Some(name) = scene.actuator_names.first() {
        return unknown(name);
    }
    if let Treatment::Baumgarte { .. } = scene.mechanism.treatment() {
        return Err(StraightLineError::Gains);
    }
    match scene.mechanism.friction(0) {
        Some(_) => Err(StraightLineError::Unknown { what: "friction that follows reactions".to_owned() }),
        None => Ok(()),
    }
}
