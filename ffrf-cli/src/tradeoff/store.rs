//! What a sweep keeps in its folder, so that one that was killed goes on where it was.
//!
//! `study.json` says what was asked, `reference.json` holds the reference, `runs/KEY.jsonl` outcomes, one a line: those
//! that had come when the file before was safe, `target.json` what was counted on cores. Every file is whole or not there.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use ffrf_host::tradeoff::{Channel, Configuration, Outcome, Reference};

use super::asked::{Asked, fnv1a};
use super::saved::{outcome_from_json, outcome_to_json, reference_from_json, reference_to_json};
use super::target_counts::TargetCounts;

/// Where outcomes are, in the folder of a sweep.
const RUNS: &str = "runs";
/// Where counts on cores are.
const TARGET: &str = "target.json";

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
            let runs = folder.join(RUNS);
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
        let wanted: BTreeSet<String> = configurations.iter().map(Configuration::key).collect();
        let folder = self.folder.join(RUNS);
        let about = |path: &Path| format!("{}", path.display());
        let mut known = BTreeMap::new();
        for entry in fs::read_dir(&folder).with_context(|| about(&folder))? {
            let file = entry.with_context(|| about(&folder))?.path();
            if file.extension().is_none_or(|extension| extension != "jsonl") {
                continue;
            }
            for line in read(&file)?.lines() {
                let outcome = outcome_from_json(line).with_context(|| about(&file))?;
                let key = outcome.configuration.key();
                if wanted.contains(&key) {
                    known.insert(key, outcome);
                }
            }
        }
        Ok(known)
    }

    /// Keeps outcomes, all in one file that is whole or not there: a file that is safe on a disk takes longer than many a run.
    pub fn keep(&self, outcomes: &[Outcome]) -> std::io::Result<()> {
        let Some(first) = outcomes.first() else { return Ok(()) };
        let mut text = String::new();
        for outcome in outcomes {
            text.push_str(&outcome_to_json(outcome).map_err(std::io::Error::other)?);
            text.push('\n');
        }
        let name = file_name(&first.configuration.key());
        ffrf_model::write_file(self.folder.join(RUNS).join(name), text.as_bytes())
    }

    /// What was counted on cores.
    pub fn target_counts(&self) -> Result<TargetCounts> {
        let file = self.folder.join(TARGET);
        if !file.exists() {
            return Ok(TargetCounts::default());
        }
        serde_json::from_str(&read(&file)?).with_context(|| format!("{}", file.display()))
    }

    /// Keeps what was counted on cores.
    pub fn keep_target_counts(&self, counts: &TargetCounts) -> Result<()> {
        write(&self.folder.join(TARGET), &serde_json::to_string(counts)?)
    }
}

/// Longest name of a file: file systems take 255 bytes, and what is being written has a few more.
const LONGEST: usize = 200;

/// The name of the file for outcomes of which this is the first key. It may name many bodies and terms; what is in the file says
/// all of them, so that a long name is cut and told apart by its hash.
fn file_name(key: &str) -> String {
    if key.len() <= LONGEST {
        return format!("{key}.jsonl");
    }
    let begin: String = key.chars().take(LONGEST / 2).filter(char::is_ascii).collect();
    format!("{begin}-{:016x}.jsonl", fnv1a(key.as_bytes()))
}

fn read(file: &Path) -> Result<String> {
    fs::read_to_string(file).with_context(|| format!("{}", file.display()))
}

fn write(file: &Path, text: &str) -> Result<()> {
    ffrf_model::write_file(file, format!("{text}\n").as_bytes())
        .with_context(|| format!("{}: cannot be written", file.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_keys_have_short_names_that_differ() {
        let long = |end: &str| format!("{}{end}", "body_of_a_scene.m.0.5+".repeat(40));
        let (first, second) = (file_name(&long("a")), file_name(&long("b")));
        assert!(first != second && first.len() < LONGEST && first.ends_with(".jsonl"), "{first}");
        assert_eq!(file_name("m4-full-f64-rk4-h1e-3"), "m4-full-f64-rk4-h1e-3.jsonl");
    }
}
