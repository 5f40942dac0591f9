//! The projection of a scene onto its joints, run once on numbers that write down what is computed with them.

use ffrf_codegen::ArrayFunction;
use ffrf_runtime::mechanism::{Assembly, EvaluatedJoint, Treatment};
use ffrf_trace::Traced;

use super::accelerations::{check, trace};
use super::arguments::Arguments;
use super::motions::numbers;
use super::{Motions, StraightLineError};
use crate::scene::Scene;

/// One correction of places and one of velocities by one factorisation, as a function of state and drives, for explicit integrators.
///
/// ```text
/// fn NAME(state: &[f64; S], drives: &[[f64; 3]; D], projected: &mut [f64; S + 4 R]) -> bool
/// ```
///
/// `state`, `drives` and the result: see [`accelerations`](super::accelerations()). `projected`: the state after the corrections,
/// and for each of the R rows of all joints what it left over before: of places, then of velocities; then both after them.
///
/// `None` where nothing is projected. Errors: see [`StraightLineError`].
pub fn projection(
    scene: &Scene,
    motions: &Motions,
    name: &str,
) -> Result<Option<ArrayFunction>, StraightLineError> {
    corrections(scene, motions, name, false)
}

/// The same after linearly implicit steps, measured by the matrix of their stages.
///
/// ```text
/// fn NAME(state: &[f64; S], gamma_h: f64, drives: &[[f64; 3]; D], projected: &mut [f64; S + 4 R]) -> bool
/// ```
///
/// `None` where nothing is projected, and where soft rows resist. Errors: see [`StraightLineError`].
pub fn implicit_projection(
    scene: &Scene,
    motions: &Motions,
    name: &str,
) -> Result<Option<ArrayFunction>, StraightLineError> {
    if scene.mechanism.soft(0).is_some() {
        return Ok(None);
    }
    corrections(scene, motions, name, true)
}

fn corrections(
    scene: &Scene,
    motions: &Motions,
    name: &str,
    is_implicit: bool,
) -> Result<Option<ArrayFunction>, StraightLineError> {
    let is_projected = matches!(scene.mechanism.treatment(), Treatment::Projection { .. });
    if !is_projected || scene.mechanism.connections().is_empty() {
        return Ok(None);
    }
    check(scene)?;
    let arguments = Arguments::of(scene, motions);
    let (results, tape) = trace(scene, &arguments, |system, state, _| {
        let mut residuals = Vec::new();
        let mut look = |joints: &[Option<EvaluatedJoint<Traced>>]| {
            for level in [0, 1] {
                let rows = joints.iter().flatten().flat_map(EvaluatedJoint::residuals);
                residuals.extend(rows.map(|residuals| residuals[level]));
            }
        };
        let gamma_h = is_implicit.then(|| arguments.gamma_h(scene));
        let projected = system.correct_once(Traced::number(0.0), state.clone(), gamma_h, &mut look)?;
        Ok(projected.iter().flat_map(numbers).chain(residuals).collect())
    })?;
    let documentation = [
        "One correction of places and one of velocities onto the joints, in straight-line code.",
        if is_implicit {
            "After linearly implicit steps, by the matrix of their stages, with `gamma_h` (s)."
        } else {
            "After explicit steps, by the mass matrix."
        },
        "",
        "`state`: for each body position 3 (inertial), orientation 4 (i, j, k, w), modal coordinates, velocity 3 (inertial),",
        "angular velocity 3 (body), modal rates. `drives`: for each joint zeros, and behind it value, rate, acceleration of its drive.",
        "`projected`: the state after it, and what each row of the joints left over before, of places, then of velocities, then both",
        "after it. `false`: the state is one in which other branches of the equations hold, and the results are not to be used.",
        "",
    ];
    let documentation = arguments.documentation(&documentation, &[("state", 13, 2)]);
    let mut inputs = vec![arguments.state, arguments.drives];
    if is_implicit {
        inputs.insert(1, arguments.gamma_h);
    }
    Ok(Some(ArrayFunction {
        name: name.to_owned(),
        documentation,
        inputs,
        output: "projected",
        graph: tape.graph,
        calls: tape.calls,
        results,
        conditions: tape.conditions,
    }))
}
