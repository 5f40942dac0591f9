//! A scene with its files, as it is packed into an FMU and as it is found there.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use ffrf_host::scene::file::SceneFile;
use ffrf_host::scene::{Scene, SceneError};
use sha2::{Digest, Sha256};
use thiserror::Error;

use crate::packed::{packed_path, redirect, sources};
use crate::variables::{Role, Variable, variables};

/// Name of the scene file in the resources.
pub const SCENE: &str = "scene.toml";

/// What an FMU is made of.
pub struct Model {
    /// The scene file, with the names that files have in `folder`.
    pub(crate) file: SceneFile,
    /// Where the files are that the scene names.
    pub(crate) folder: PathBuf,
    /// Name of the scene file.
    pub(crate) source_name: String,
    /// What other tools set and read; a variable's place is its value reference.
    pub variables: Vec<Variable>,
    /// What tells FMUs apart: two with the same token do the same.
    pub token: String,
    /// The files of the resources: path there, and content; the scene first.
    pub files: Vec<(String, Vec<u8>)>,
    /// Number of modes of each body.
    pub(crate) modes: Vec<usize>,
    /// Number of actuators.
    pub(crate) actuators: usize,
    /// Simulated time, time between samples (s), and relative tolerance if there is one.
    pub experiment: (f64, f64, Option<f64>),
}

/// Why a scene cannot be an FMU.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ModelError {
    /// The scene cannot be read or composed.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A file cannot be read.
    #[error("{}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// Two different files would lie at the same place.
    #[error(
        "two different files of the scene would both be `{path}` in the FMU: give one of them another name"
    )]
    SamePlace {
        /// The place in the resources.
        path: String,
    },
    /// Two variables would have the same name.
    #[error("two variables of the FMU would be called `{name}`: give the sensor or body another name")]
    SameName {
        /// The name.
        name: String,
    },
}

impl Model {
    /// The model of a scene where it is. Errors: see [`ModelError`].
    pub fn of_scene(path: &Path) -> Result<Self, ModelError> {
        Self::read(path, |_, _| {})
    }

    /// The model in the resources of an FMU. Errors: see [`ModelError`].
    pub fn in_resources(folder: &Path) -> Result<Self, ModelError> {
        Self::read(&folder.join(SCENE), redirect)
    }

    fn read(path: &Path, redirect: impl FnOnce(&mut SceneFile, &Path)) -> Result<Self, ModelError> {
        let folder = path.parent().unwrap_or_else(|| Path::new("")).to_owned();
        let bytes = content(path)?;
        let mut file = SceneFile::read(path)?;
        redirect(&mut file, &folder);
        let mut files = vec![(SCENE.to_owned(), bytes)];
        for named in sources(&file, &folder) {
            let (place, bytes) = (packed_path(&named), content(&folder.join(&named))?);
            match files.iter().find(|(known, _)| *known == place) {
                None => files.push((place, bytes)),
                Some((_, known)) if *known == bytes => {}
                Some(_) => return Err(ModelError::SamePlace { path: place }),
            }
        }
        let scene = Scene::compose(&file, &folder)?;
        let variables = variables(&file, &scene);
        let mut names = BTreeSet::new();
        if let Some(twice) = variables.iter().find(|variable| !names.insert(&variable.name)) {
            return Err(ModelError::SameName { name: twice.name.clone() });
        }
        Ok(Self {
            token: token(&files),
            modes: scene.mechanism.bodies().iter().map(|body| body.mode_count()).collect(),
            actuators: scene.mechanism.actuators().len(),
            experiment: (scene.settings.duration, scene.settings.output_step, file.simulation.tolerance),
            file,
            folder,
            source_name: path
                .file_name()
                .map_or_else(String::new, |name| name.to_string_lossy().into_owned()),
            variables,
            files,
        })
    }

    /// The scene with these values of its parameters, in the order of the variables. Errors: see [`SceneError`].
    pub(crate) fn scene(&self, parameters: &[f64]) -> Result<Scene, SceneError> {
        let mut file = self.file.clone();
        let keys = self.variables.iter().filter_map(|variable| match variable.role {
            Role::Parameter(parameter, start) => Some((parameter, start)),
            _ => None,
        });
        for ((parameter, start), value) in keys.zip(parameters) {
            // what stays as it was stays unsaid where the file does not say it
            if value.to_bits() != start.to_bits() {
                parameter.write(&mut file, &self.modes, *value);
            }
        }
        Scene::compose(&file, &self.folder)
    }

    /// The values of all parameters as the scene file has them.
    pub(crate) fn starts(&self) -> Vec<f64> {
        let starts = self.variables.iter().filter_map(|variable| match variable.role {
            Role::Parameter(_, start) => Some(start),
            _ => None,
        });
        starts.collect()
    }
}

fn content(path: &Path) -> Result<Vec<u8>, ModelError> {
    std::fs::read(path).map_err(|source| ModelError::Read { path: path.to_owned(), source })
}

/// The fingerprint of all files and of the version that reads them.
fn token(files: &[(String, Vec<u8>)]) -> String {
    fingerprint(files.iter().flat_map(|(path, bytes)| [path.as_bytes(), bytes]))
}

/// The fingerprint of parts, and of this version.
pub(crate) fn fingerprint<'a>(parts: impl IntoIterator<Item = &'a [u8]>) -> String {
    let mut hash = Sha256::new();
    hash.update(crate::MARK);
    for part in parts {
        // lengths keep neighbours apart
        hash.update((part.len() as u64).to_le_bytes());
        hash.update(part);
    }
    hash.finalize().iter().map(|byte| format!("{byte:02x}")).collect()
}
