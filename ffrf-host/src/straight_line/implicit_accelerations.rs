//! The equations of a linearly implicit stage of a scene, run once on numbers that write down what is computed with them.

use ffrf_codegen::ArrayFunction;
use ffrf_runtime::System;
use ffrf_trace::Traced;

use super::accelerations::{check, trace};
use super::arguments::Arguments;
use super::{Motions, StraightLineError};
use crate::scene::Scene;

/// The accelerations that a linearly implicit stage finds as a function of state, of what it subtracts, of γ h and of drives.
///
/// ```text
/// fn NAME(
///     state: &[f64; S], subtracted: &[f64; R], gamma_h: f64, drives: &[[f64; 3]; D], accelerations: &mut [f64; V],
/// ) -> bool
/// ```
///
/// `state`, `drives`, `accelerations` and the result: see [`accelerations`](super::accelerations()). `subtracted`: of each body
/// what is subtracted from the rates of its position (inertial), as an angular velocity (body), of its modal coordinates,
/// velocity (inertial), angular velocity (body) and modal rates; zeros where a stage subtracts nothing. Rotations are not in the
/// chart of a step but about the state itself, so the increment that has led there is no argument.
///
/// Errors: see [`StraightLineError`].
pub fn implicit_accelerations(
    scene: &Scene,
    motions: &Motions,
    name: &str,
) -> Result<ArrayFunction, StraightLineError> {
    check(scene)?;
    let arguments = Arguments::of(scene, motions);
    let (results, tape) = trace(scene, &arguments, |system, state, off| {
        let (subtracted, gamma_h) = (arguments.subtracted(off), arguments.gamma_h(scene));
        let none = system.no_change(state);
        // at the state itself: what runs keeps orientations of length one
        let time = Traced::number(0.0);
        let rates = system.implicit_rates_at(time, state.clone(), &none, gamma_h, Some(&subtracted))?;
        Ok(Arguments::results(&rates))
    })?;
    let documentation = [
        "Accelerations of the whole mechanism in a linearly implicit stage, in straight-line code.",
        "",
        "`state`: for each body position 3 (inertial), orientation 4 (i, j, k, w), modal coordinates, velocity 3 (inertial),",
        "angular velocity 3 (body), modal rates. `subtracted` from the rates, for each body: of the position 3 (inertial), as",
        "angular velocity 3 (body), of modal coordinates, velocity 3 (inertial), angular velocity 3 (body), modal rates; zeros if",
        "nothing is. `gamma_h`: s. `drives`: for each joint zeros, and behind it value, rate, acceleration of its drive.",
        "`accelerations`: for each body of the frame origin 3 (inertial), angular 3 (body), modal. `false`: the state is one in",
        "which other branches of the equations hold, and the results are not to be used.",
        "",
    ];
    let arrays = [("state", 13, 2), ("subtracted", 12, 2), ("accelerations", 6, 1)];
    Ok(ArrayFunction {
        name: name.to_owned(),
        documentation: arguments.documentation(&documentation, &arrays),
        inputs: vec![arguments.state, arguments.subtracted, arguments.gamma_h, arguments.drives],
        output: "accelerations",
        graph: tape.graph,
        calls: tape.calls,
        results,
        conditions: tape.conditions,
    })
}
