//! The model description of FMI 3.0.

use super::xml::attribute;
use super::{LOG_CATEGORIES, experiment, units};
use crate::model::Model;
use crate::sources::Sources;
use crate::variables::Role;

pub(super) fn description(model: &Model, name: &str, identifier: &str, sources: Option<&Sources>) -> String {
    let (mut variables, mut outputs, mut unknowns) = (String::new(), String::new(), String::new());
    for (reference, variable) in model.variables.iter().enumerate() {
        let role = match variable.role {
            Role::Time => "causality=\"independent\" variability=\"continuous\"".to_owned(),
            Role::Parameter(_, start) => {
                format!("causality=\"parameter\" variability=\"fixed\" initial=\"exact\" start=\"{start:?}\"")
            }
            Role::Input(_, start) => {
                format!("causality=\"input\" variability=\"continuous\" start=\"{start:?}\"")
            }
            Role::Output(_) => {
                outputs.push_str(&format!("    <Output valueReference=\"{reference}\"/>\n"));
                unknowns.push_str(&format!("    <InitialUnknown valueReference=\"{reference}\"/>\n"));
                "causality=\"output\" variability=\"continuous\" initial=\"calculated\"".to_owned()
            }
            Role::Local(_) => {
                "causality=\"local\" variability=\"continuous\" initial=\"calculated\"".to_owned()
            }
        };
        let unit =
            if variable.unit.is_empty() { String::new() } else { format!(" unit=\"{}\"", variable.unit) };
        variables.push_str(&format!(
            "    <Float64 name=\"{}\" valueReference=\"{reference}\" {role}{unit} description=\"{}\"/>\n",
            attribute(&variable.name),
            attribute(&variable.description)
        ));
    }
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <fmiModelDescription fmiVersion=\"3.0\" modelName=\"{name}\" instantiationToken=\"{token}\" \
         description=\"flexible multibody system\" generationTool=\"ffrf {version}\" variableNamingConvention=\"flat\">\n  \
         <CoSimulation modelIdentifier=\"{identifier}\" canHandleVariableCommunicationStepSize=\"true\" \
         canGetAndSetFMUState=\"true\" canSerializeFMUState=\"true\"/>\n\
         {units}{LOG_CATEGORIES}{experiment}  <ModelVariables>\n{variables}  </ModelVariables>\n  \
         <ModelStructure>\n{outputs}{unknowns}  </ModelStructure>\n</fmiModelDescription>\n",
        name = attribute(name),
        token = sources.map_or(&model.token, |sources| &sources.token),
        version = env!("CARGO_PKG_VERSION"),
        units = units(model),
        experiment = experiment(model),
    )
}
