//! `modelDescription.xml`: what an FMU says of itself.

mod fmi2;
mod fmi3;
mod xml;

pub(crate) use self::xml::attribute;
use crate::model::Model;
use crate::sources::Sources;

/// A version of the standard.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fmi {
    /// 2.0.
    Two,
    /// 3.0.
    Three,
}

/// The model description for a version of the standard. `identifier`: the name of the binary without its ending; `name`:
/// what people call the model; `sources`: what is inside in C, in place of the scene.
pub fn description(
    model: &Model,
    fmi: Fmi,
    name: &str,
    identifier: &str,
    sources: Option<&Sources>,
) -> String {
    match fmi {
        Fmi::Two => fmi2::description(model, name, identifier, sources),
        Fmi::Three => fmi3::description(model, name, identifier, sources),
    }
}

/// The C identifier that is nearest to a name.
pub fn identifier(name: &str) -> String {
    let mut text: String = name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    if text.chars().next().is_none_or(|first| first.is_ascii_digit()) {
        text.insert(0, '_');
    }
    text
}

/// Units by their exponents of kg, m, s and rad.
const UNITS: [(&str, [i8; 4]); 10] = [
    ("s", [0, 0, 1, 0]),
    ("m", [0, 1, 0, 0]),
    ("m/s", [0, 1, -1, 0]),
    ("m/s2", [0, 1, -2, 0]),
    ("rad", [0, 0, 0, 1]),
    ("rad/s", [0, 0, -1, 1]),
    ("N", [1, 1, -2, 0]),
    ("N.m", [1, 2, -2, 0]),
    ("Pa", [1, -1, -2, 0]),
    ("J", [1, 2, -2, 0]),
];

/// The units that a model uses: both versions of the standard write them alike.
fn units(model: &Model) -> String {
    let mut text = String::from("  <UnitDefinitions>\n");
    for (name, exponents) in UNITS {
        if !model.variables.iter().any(|variable| variable.unit == name) {
            continue;
        }
        let base = ["kg", "m", "s", "rad"].iter().zip(exponents);
        let base = base.filter(|(_, exponent)| *exponent != 0);
        let base: String = base.map(|(unit, exponent)| format!(" {unit}=\"{exponent}\"")).collect();
        text.push_str(&format!("    <Unit name=\"{name}\"><BaseUnit{base}/></Unit>\n"));
    }
    text.push_str("  </UnitDefinitions>\n");
    text
}

/// The kinds of messages, which both versions write alike.
const LOG_CATEGORIES: &str = "  <LogCategories>\n    <Category name=\"logStatusError\" description=\"why something could \
                              not be done\"/>\n    <Category name=\"logEvents\" description=\"events of the scene\"/>\n  \
                              </LogCategories>\n";

/// How long and how finely the scene is simulated, which both versions write alike.
fn experiment(model: &Model) -> String {
    let (stop, step, tolerance) = model.experiment;
    let tolerance = tolerance.map_or_else(String::new, |tolerance| format!(" tolerance=\"{tolerance:?}\""));
    format!(
        "  <DefaultExperiment startTime=\"0.0\" stopTime=\"{stop:?}\"{tolerance} stepSize=\"{step:?}\"/>\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identifiers_are_names_of_c() {
        for (name, expected) in [("slider_crank", "slider_crank"), ("4-bar", "_4_bar"), ("", "_"), ("Ä", "_")]
        {
            assert_eq!(identifier(name), expected);
        }
    }
}
