//! The sources of an FMU in C: the step of its scene as the generator prints it, and the functions of the standard about it.
//!
//! ```text
//! part_NAME.h, part_NAME.c     the step: bodies, joints, forces, sensors (ffrf-codegen)
//! fmu.c                        tables of the variables, and the parts of `wrapper/` for one version of the standard
//! buildDescription.xml         FMI 3.0: what a compiler is given
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
        // no header of a system is called like this, and no identifier of C is reserved that begins so
        let name = format!("part_{}", identifier.trim_start_matches('_'));
        let options = GenerateOptions { name, ..GenerateOptions::default() };
        let step = generate_mechanism_c(&mechanism, &options)?;
        let upper = step.prefix.to_uppercase();
        let [types, functions, absent] = match fmi {
            Fmi::Two => FMI2,
            Fmi::Three => FMI3,
        };
        let fill = |part: &str| part.replace("@P", &step.prefix).replace("@M", &upper);
        let parts = [types].into_iter().chain(BEHIND).chain([functions, absent]);
        let (head, parts) = (fill(BEFORE), parts.map(fill).collect::<Vec<String>>().join("\n"));
        let tables = tables::tables(self, &mechanism);
        let texts = [&step.header, &step.source, &head, &tables, &parts];
        let token = fingerprint(texts.map(|text| text.as_bytes()));
        let fmu = format!("{head}\n#define TOKEN \"{token}\"\n\n{tables}\n{parts}");
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
