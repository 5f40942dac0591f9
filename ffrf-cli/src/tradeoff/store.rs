//! What a sweep keeps in its folder, so that one that was killed goes on where it was.
//!
//! `study.json` says what was asked, `reference.json` holds the reference, `runs/KEY.json` one outcome each. Every file is
//! whole or not there.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use ffrf_host::tradeoff::{Channel, Configuration, Outcome, Reference};

use super::asked::Asked;
use super::saved::{outcome_from_json, outcome_to_json, reference_from_json, reference_to_json};

/// The folder of a sweep.
pub struct Store {
    folder: PathBuf,
}

impl Store {
    /// Opens a folder for what is asked. Errors: it holds runs of something else.
    pub fn open(folder: &Path, asked: &Asked) -> Result<Self> {
        let file = folder.join("study.json");
        if file.exists() {
            let found: Asked =
                serde_json::from_str(&read(&file)?).with_context(|| format!("{}", file.display()))?;
            if let Some(what) = asked.difference(&found) {
                bail!(
                    "{}: holds a sweep with {what}; name another folder, or remove this one",
                    folder.display()
                );
            }
        } else {
            let runs = folder.join("runs");
            fs::create_dir_all(&runs).with_context(|| format!("{}: cannot be made", runs.display()))?;
            write(&file, &serde_json::to_string(asked)?)?;
        }
        Ok(Self { folder: folder.to_owned() })
    }

    /// The reference, if it is there.
    pub fn reference(&self, channels: Vec<Channel>) -> Result<Option<Reference>> {
        let file = self.folder.join("reference.json");
        if !file.exists() {
            return Ok(None);
        }
        let about = || format!("{}", file.display());
        reference_from_json(&read(&file)?, channels).with_context(about).map(Some)
    }

    /// Keeps the reference.
    pub fn keep_reference(&self, reference: &Reference) -> Result<()> {
        write(&self.folder.join("reference.json"), &reference_to_json(reference)?)
    }

    /// The outcomes that are there, of these configurations.
    pub fn outcomes(&self, configurations: &[Configuration]) -> Result<BTreeMap<String, Outcome>> {
        let mut known = BTreeMap::new();
        for configuration in configurations {
            let file = self.run_file(configuration);
            if file.exists() {
                let about = || format!("{}", file.display());
                let outcome = outcome_from_json(&read(&file)?).with_context(about)?;
                known.insert(configuration.key(), outcome);
            }
        }
        Ok(known)
    }

    /// Keeps one outcome.
    pub fn keep(&self, outcome: &Outcome) -> std::io::Result<()> {
        let text = outcome_to_json(outcome).map_err(std::io::Error::other)?;
        ffrf_model::write_file(self.run_file(&outcome.configuration), format!("{text}\n").as_bytes())
    }

    fn run_file(&self, configuration: &Configuration) -> PathBuf {
        self.folder.join("runs").join(format!("{}.json", configuration.key()))
    }
}

fn read(file: &Path) -> Result<String> {
    fs::read_to_string(file).with_context(|| format!("{}", file.display()))
}

fn write(file: &Path, text: &str) -> Result<()> {
    ffrf_model::write_file(file, format!("{text}\n").as_bytes())
        .with_context(|| format!("{}: cannot be written", file.display()))
}
