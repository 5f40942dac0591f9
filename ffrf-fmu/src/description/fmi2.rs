//! The model description of FMI 2.0.

use super::xml::attribute;
use super::{LOG_CATEGORIES, experiment, units};
use crate::model::Model;
use crate::sources::Sources;
use crate::variables::Role;

pub(super) fn description(model: &Model, name: &str, identifier: &str, sources: Option<&Sources>) -> String {
    let (mut variables, mut unknowns) = (String::new(), String::new());
    for (reference, variable) in model.variables.iter().enumerate() {
        let (role, start) = match variable.role {
            Role::Time => ("causality=\"independent\" variability=\"continuous\"", None),
            Role::Parameter(_, start) => {
                ("causality=\"parameter\" variability=\"fixed\" initial=\"exact\"", Some(start))
            }
            Role::Input(_, start) => ("causality=\"input\" variability=\"continuous\"", Some(start)),
            Role::Output(_) => {
                // counted from one
                unknowns.push_str(&format!("      <Unknown index=\"{}\"/>\n", reference + 1));
                ("causality=\"output\" variability=\"continuous\" initial=\"calculated\"", None)
            }
            Role::Local(_) => ("causality=\"local\" variability=\"continuous\" initial=\"calculated\"", None),
        };
        let unit =
            if variable.unit.is_empty() { String::new() } else { format!(" unit=\"{}\"", variable.unit) };
        let start = start.map_or_else(String::new, |start| format!(" start=\"{start:?}\""));
        variables.push_str(&format!(
            "    <ScalarVariable name=\"{}\" valueReference=\"{reference}\" {role} description=\"{}\"><Real{unit}{start}/>\
             </ScalarVariable>\n",
            attribute(&variable.name),
            attribute(&variable.description)
        ));
    }
    let list = |name: &str| {
        if unknowns.is_empty() { String::new() } else { format!("    <{name}>\n{unknowns}    </{name}>\n") }
    };
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <fmiModelDescription fmiVersion=\"2.0\" modelName=\"{name}\" guid=\"{token}\" \
         description=\"flexible multibody system\" generationTool=\"ffrf {version}\" variableNamingConvention=\"flat\">\n  \
         <CoSimulation modelIdentifier=\"{identifier}\" canHandleVariableCommunicationStepSize=\"true\" \
         canGetAndSetFMUstate=\"true\" canSerializeFMUstate=\"true\"{inside}\n\
         {units}{LOG_CATEGORIES}{experiment}  <ModelVariables>\n{variables}  </ModelVariables>\n  \
         <ModelStructure>\n{outputs}{initial}  </ModelStructure>\n</fmiModelDescription>\n",
        name = attribute(name),
        token = sources.map_or(&model.token, |sources| &sources.token),
        version = env!("CARGO_PKG_VERSION"),
        inside = source_files(sources),
        units = units(model),
        experiment = experiment(model),
        outputs = list("Outputs"),
        initial = list("InitialUnknowns"),
    )
}

/// The end of the element for co-simulation: what is compiled.
fn source_files(sources: Option<&Sources>) -> String {
    let Some(sources) = sources else { return "/>".to_owned() };
    let files = sources.files.iter().take(sources.compiled);
    let files: String = files.map(|(name, _)| format!("<File name=\"{}\"/>", attribute(name))).collect();
    format!("><SourceFiles>{files}</SourceFiles></CoSimulation>")
}
