//! The sources of an FMU in C: the step of its scene as the generator prints it, and the functions of the standard about it.
//!
//! ```text
//! IDENTIFIER.h, IDENTIFIER.c    the step: bodies, joints, forces, sensors (ffrf-codegen)
//! fmu.c                         tables of the variables, and the parts of `wrapper/` for one version of the standard
//! buildDescription.xml          FMI 3.0: what a compiler is given
//! ```

mod build_description;
mod composition;
mod tables;

use ffrf_codegen::mechanism::MechanismModel;
use ffrf_codegen::{CodegenError, GenerateOptions, generate_mechanism_c};
use ffrf_host::scene::{Scene, SceneError};
use thiserror::Error;

use crate::description::Fmi;
use crate::model::{Model, fingerprint};
use crate::sources::Sources;

/// Why a scene has no sources in C.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum SourcesError {
    /// Something of the scene is not in generated C, or it cannot be assembled.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The step cannot be printed.
    #[error(transparent)]
    Codegen(#[from] CodegenError),
}

/// The parts of `fmu.c` before and behind the types of the standard.
const BEFORE: &str = include_str!("wrapper/fmu.c");
const BEHIND: [&str; 4] = [
    include_str!("wrapper/types.c"),
    include_str!("wrapper/way.c"),
    include_str!("wrapper/life.c"),
    include_str!("wrapper/states.c"),
];
/// Types and functions of FMI 2.0.
const FMI2: [&str; 3] = [
    include_str!("wrapper/fmi2_types.c"),
    include_str!("wrapper/fmi2.c"),
    include_str!("wrapper/fmi2_absent.c"),
];
/// Those of FMI 3.0.
const FMI3: [&str; 3] = [
    include_str!("wrapper/fmi3_types.c"),
    include_str!("wrapper/fmi3.c"),
    include_str!("wrapper/fmi3_absent.c"),
];

impl Model {
    /// The sources of the model in C. `identifier`: see [`identifier`](crate::description::identifier).
    ///
    /// The same scene gives the same text, to the byte. Errors: see [`SourcesError`].
    pub fn c_sources(&self, fmi: Fmi, identifier: &str) -> Result<Sources, SourcesError> {
        let scene = Scene::compose(&self.file, &self.folder)?;
        let composition = composition::composition(&self.file, &scene, &self.variables);
        let mechanism =
            MechanismModel { composition: Some(composition?), ..scene.mechanism_model(&self.source_name)? };
        let options = GenerateOptions { name: name_in_c(identifier), ..GenerateOptions::default() };
        let step = generate_mechanism_c(&mechanism, &options)?;
        let upper = step.prefix.to_uppercase();
        let [types, functions, absent] = match fmi {
            Fmi::Two => FMI2,
            Fmi::Three => FMI3,
        };
        let parts: Vec<&str> = [BEFORE, types].into_iter().chain(BEHIND).chain([functions, absent]).collect();
        let filled: Vec<String> =
            parts.iter().map(|part| part.replace("@P", &step.prefix).replace("@M", &upper)).collect();
        let tables = tables::tables(self, &mechanism);
        let token = fingerprint(
            [step.header.as_bytes(), step.source.as_bytes(), tables.as_bytes()]
                .into_iter()
                .chain(filled.iter().map(String::as_bytes)),
        );
        let defined = format!("#define TOKEN \"{token}\"\n\n{tables}");
        let fmu = [&[filled[0].clone(), defined], &filled[1..]].concat().join("\n");
        let (header, source) = (format!("{}.h", step.prefix), format!("{}.c", step.prefix));
        let mut files = vec![(source, step.source), ("fmu.c".to_owned(), fmu), (header, step.header)];
        let compiled = 2;
        if fmi == Fmi::Three {
            let names = files.iter().take(compiled).map(|(name, _)| name.as_str());
            files.push((
                "buildDescription.xml".to_owned(),
                build_description::build_description(identifier, names),
            ));
        }
        Ok(Sources { files, compiled, token })
    }
}

/// What names of the step begin with: an identifier of C that the standard of C leaves to users, and none of the wrapper's.
fn name_in_c(identifier: &str) -> String {
    let name = identifier.trim_start_matches('_');
    let is_name = name.chars().next().is_some_and(|first| first.is_ascii_alphabetic());
    if is_name && !name.eq_ignore_ascii_case("fmu") { name.to_owned() } else { format!("scene_{name}") }
}

#[cfg(test)]
mod tests {
    use super::name_in_c;

    #[test]
    fn names_of_the_step_are_those_of_users() {
        for (identifier, name) in [
            ("slider_crank", "slider_crank"),
            ("_4_bar", "scene_4_bar"),
            ("_", "scene_"),
            ("fmu", "scene_fmu"),
        ] {
            assert_eq!(name_in_c(identifier), name);
        }
    }
}
