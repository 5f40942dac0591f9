//! What a sweep keeps in its folder, so that one that was killed goes on where it was.
//!
//! `study.json` says what was asked, `reference.json` holds the reference, `runs/KEY.json` one outcome each. Every file is
//! whole or not there.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use ffrf_host::tradeoff::{
    Channel, Configuration, Finding, History, Measured, Outcome, Quantity, Reference, StaticCost, Study,
};
use serde::{Deserialize, Serialize};

/// The folder of a sweep.
pub struct Store {
    folder: PathBuf,
}

/// What every run of a folder has in common.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub struct Asked {
    /// Version of the command: other versions may give other numbers.
    version: String,
    /// The scene file as it is.
    scene: String,
    /// Hash of each file that the scene names (FNV-1a, 64 bits).
    inputs: BTreeMap<String, String>,
    quantities: Vec<String>,
    reference_tolerance: f64,
}

impl Asked {
    /// What is asked of a scene. Errors: a file cannot be read.
    pub fn of(
        scene: &Path,
        study: &Study,
        quantities: &[Quantity],
        reference_tolerance: f64,
    ) -> Result<Self> {
        let folder = scene.parent().unwrap_or_else(|| Path::new(""));
        let read = |path: &Path| fs::read(path).with_context(|| format!("{}", path.display()));
        let hashed = study.inputs().into_iter().map(|path| {
            let name = path.strip_prefix(folder).unwrap_or(&path).display().to_string();
            Ok((name, format!("{:016x}", fnv1a(&read(&path)?))))
        });
        Ok(Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            scene: String::from_utf8_lossy(&read(scene)?).into_owned(),
            inputs: hashed.collect::<Result<_>>()?,
            quantities: quantities.iter().map(Quantity::to_string).collect(),
            reference_tolerance,
        })
    }
}

impl Store {
    /// Opens a folder for what is asked. Errors: it holds runs of something else.
    pub fn open(folder: &Path, asked: &Asked) -> Result<Self> {
        let file = folder.join("study.json");
        if file.exists() {
            let found: Asked = read_json(&file)?;
            if found != *asked {
                let what = difference(&found, asked);
                bail!(
                    "{}: holds a sweep with {what}; name another folder, or remove this one",
                    folder.display()
                );
            }
        } else {
            let runs = folder.join("runs");
            fs::create_dir_all(&runs).with_context(|| format!("{}: cannot be made", runs.display()))?;
            write_json(&file, asked)?;
        }
        Ok(Self { folder: folder.to_owned() })
    }

    /// The reference, if it is there.
    pub fn reference(&self, channels: Vec<Channel>) -> Result<Option<Reference>> {
        let file = self.folder.join("reference.json");
        if !file.exists() {
            return Ok(None);
        }
        let saved: SavedReference = read_json(&file)?;
        Ok(Some(Reference {
            channels,
            times: saved.times,
            history: History { values: saved.values },
            scales: saved.scales,
            own_errors: saved.own_errors,
            tolerance: saved.tolerance,
            steps: saved.steps,
            modes: saved.modes,
        }))
    }

    /// Keeps the reference.
    pub fn keep_reference(&self, reference: &Reference) -> Result<()> {
        let saved = SavedReference {
            channels: reference.channels.iter().map(|channel| channel.name.clone()).collect(),
            tolerance: reference.tolerance,
            steps: reference.steps,
            modes: reference.modes,
            scales: reference.scales.clone(),
            own_errors: reference.own_errors.clone(),
            times: reference.times.clone(),
            values: reference.history.values.clone(),
        };
        write_json(&self.folder.join("reference.json"), &saved)
    }

    /// The outcomes that are there, of these configurations.
    pub fn outcomes(&self, configurations: &[Configuration]) -> Result<BTreeMap<String, Outcome>> {
        let mut known = BTreeMap::new();
        for configuration in configurations {
            let file = self.run_file(configuration);
            if file.exists() {
                let saved: SavedRun = read_json(&file)?;
                let outcome = Outcome { configuration: configuration.clone(), finding: saved.finding.into() };
                known.insert(configuration.key(), outcome);
            }
        }
        Ok(known)
    }

    /// Keeps one outcome.
    pub fn keep(&self, outcome: &Outcome) -> std::io::Result<()> {
        let Configuration { modes, fidelity, scalar, integrator, step } = &outcome.configuration;
        let saved = SavedRun {
            modes: *modes,
            fidelity: fidelity.to_string(),
            scalar: scalar.name().to_owned(),
            integrator: integrator.name().to_owned(),
            step: *step,
            finding: SavedFinding::from(&outcome.finding),
        };
        let text = serde_json::to_string(&saved).map_err(std::io::Error::other)?;
        ffrf_model::write_file(self.run_file(&outcome.configuration), format!("{text}\n").as_bytes())
    }

    fn run_file(&self, configuration: &Configuration) -> PathBuf {
        self.folder.join("runs").join(format!("{}.json", configuration.key()))
    }
}

#[derive(Serialize, Deserialize)]
struct SavedReference {
    channels: Vec<String>,
    tolerance: f64,
    steps: u64,
    modes: usize,
    scales: Vec<f64>,
    own_errors: Vec<f64>,
    times: Vec<f64>,
    values: Vec<Vec<f64>>,
}

#[derive(Serialize, Deserialize)]
struct SavedRun {
    modes: usize,
    fidelity: String,
    scalar: String,
    integrator: String,
    step: f64,
    finding: SavedFinding,
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum SavedFinding {
    Finished {
        step: f64,
        steps: u64,
        evaluations: f64,
        errors: Vec<f64>,
        operations: f64,
        constants: usize,
        stack_numbers: usize,
        time: f64,
    },
    Failed(String),
}

impl From<&Finding> for SavedFinding {
    fn from(finding: &Finding) -> Self {
        match finding {
            Finding::Failed(reason) => Self::Failed(reason.clone()),
            Finding::Finished(measured) => Self::Finished {
                step: measured.step,
                steps: measured.steps,
                evaluations: measured.evaluations,
                errors: measured.errors.clone(),
                operations: measured.cost.operations,
                constants: measured.cost.constants,
                stack_numbers: measured.cost.stack_numbers,
                time: measured.time,
            },
        }
    }
}

impl From<SavedFinding> for Finding {
    fn from(saved: SavedFinding) -> Self {
        match saved {
            SavedFinding::Failed(reason) => Self::Failed(reason),
            SavedFinding::Finished {
                step,
                steps,
                evaluations,
                errors,
                operations,
                constants,
                stack_numbers,
                time,
            } => Self::Finished(Measured {
                step,
                steps,
                evaluations,
                errors,
                cost: StaticCost { operations, constants, stack_numbers },
                time,
            }),
        }
    }
}

fn read_json<T: for<'a> Deserialize<'a>>(file: &Path) -> Result<T> {
    let text = fs::read_to_string(file).with_context(|| format!("{}", file.display()))?;
    serde_json::from_str(&text).with_context(|| format!("{}", file.display()))
}

fn write_json<T: Serialize>(file: &Path, value: &T) -> Result<()> {
    let text = serde_json::to_string(value)?;
    ffrf_model::write_file(file, format!("{text}\n").as_bytes())
        .with_context(|| format!("{}: cannot be written", file.display()))
}

/// What is another in what was asked before.
fn difference(found: &Asked, asked: &Asked) -> &'static str {
    if found.version != asked.version {
        "another version of the command"
    } else if found.scene != asked.scene {
        "another scene"
    } else if found.inputs != asked.inputs {
        "other models or tables"
    } else if found.quantities != asked.quantities {
        "other quantities"
    } else {
        "another tolerance of the reference"
    }
}

fn fnv1a(bytes: &[u8]) -> u64 {
    bytes
        .iter()
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
}
