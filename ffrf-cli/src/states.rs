//! The states that `ffrf evaluate` reads, and the results that it writes.

use std::path::Path;

use anyhow::{Context, Result, bail};
use serde::{Deserialize, Serialize};

/// One state, resolved in the body frame.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct State {
    /// Modal coordinates. Shape: M.
    pub q: Vec<f64>,
    /// Angular velocity. Units: rad/s.
    pub omega: [f64; 3],
    /// Modal rates. Shape: M.
    pub q_dot: Vec<f64>,
    /// Generalised force: force, moment about the frame origin, modal forces. Shape: 6 + M.
    pub force: Vec<f64>,
    /// Velocity of the frame origin; enters the kinetic energy only. Units: m/s.
    #[serde(default)]
    pub velocity: [f64; 3],
}

/// The results for one state.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Values {
    /// Mass matrix, rows. Shape: (6 + M) square.
    pub mass_matrix: Vec<Vec<f64>>,
    /// Quadratic velocity vector, on the left-hand side. Shape: 6 + M.
    pub quadratic_velocity: Vec<f64>,
    /// Accelerations [α; ω̇; q̈]. Shape: 6 + M.
    pub acceleration: Vec<f64>,
    /// Kinetic energy. Units: J.
    pub kinetic_energy: f64,
    /// Elastic energy. Units: J.
    pub elastic_energy: f64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct StatesFile {
    states: Vec<State>,
}

#[derive(Serialize)]
struct ValuesFile<'a> {
    states: &'a [Values],
}

/// Reads the states for a body of `modes` modes.
pub fn read(path: &Path, modes: usize) -> Result<Vec<State>> {
    let text = std::fs::read_to_string(path).with_context(|| format!("{}", path.display()))?;
    parse(&text, modes).with_context(|| format!("{}", path.display()))
}

fn parse(text: &str, modes: usize) -> Result<Vec<State>> {
    let file: StatesFile = serde_json::from_str(text)?;
    for (index, state) in file.states.iter().enumerate() {
        let lengths = [
            ("q", state.q.len(), modes),
            ("q_dot", state.q_dot.len(), modes),
            ("force", state.force.len(), 6 + modes),
        ];
        for (field, found, expected) in lengths {
            if found != expected {
                bail!(
                    "states[{index}].{field}: expected {expected} numbers (the body has {modes} modes), found {found}"
                );
            }
        }
    }
    Ok(file.states)
}

/// The results as JSON text; a result that is not finite is an error that names the state.
pub fn to_json(values: &[Values]) -> Result<String> {
    for (index, state) in values.iter().enumerate() {
        let numbers =
            state.mass_matrix.iter().flatten().chain(&state.quadratic_velocity).chain(&state.acceleration);
        let scalars = [state.kinetic_energy, state.elastic_energy];
        if let Some(number) = numbers.chain(&scalars).find(|number| !number.is_finite()) {
            bail!("states[{index}]: a result is {number}: is the state of a sensible size?");
        }
    }
    let mut text = serde_json::to_string(&ValuesFile { states: values })?;
    text.push('\n');
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::parse;

    #[test]
    fn velocity_is_optional() {
        let one = r#"{"states":[{"q":[1],"omega":[0,0,1],"q_dot":[2],"force":[0,0,0,0,0,0,3]}]}"#;
        assert_eq!(parse(one, 1).unwrap()[0].velocity, [0.0; 3]);
        let moving = one.replace("\"q\":", "\"velocity\":[1,2,3],\"q\":");
        assert_eq!(parse(&moving, 1).unwrap()[0].velocity, [1.0, 2.0, 3.0]);
        assert!(parse(r#"{"states":[]}"#, 1).unwrap().is_empty());
    }

    #[test]
    fn faults_are_named() {
        let message = |text: &str, modes| format!("{:#}", parse(text, modes).unwrap_err());
        let one = r#"{"states":[{"q":[1],"omega":[0,0,1],"q_dot":[2],"force":[0,0,0,0,0,0,3]}]}"#;
        assert!(message(one, 2).contains("states[0].q: expected 2 numbers (the body has 2 modes), found 1"));
        assert!(message(&one.replace("omega", "Omega"), 1).contains("unknown field `Omega`"));
        assert!(message(&one.replace("[0,0,1]", "[0,0]"), 1).contains("array of length 3"));
        assert!(message(&one.replace("[2]", "[1e999]"), 1).contains("number out of range"));
    }
}
