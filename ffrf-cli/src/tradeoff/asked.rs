//! What decides the numbers of a sweep besides its configurations.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use ffrf_host::tradeoff::{Quantity, Study};
use serde::{Deserialize, Serialize};

/// What every run of a folder has in common.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
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
        reference_models: &BTreeMap<String, PathBuf>,
    ) -> Result<Self> {
        let folder = scene.parent().unwrap_or_else(|| Path::new(""));
        let read = |path: &Path| fs::read(path).with_context(|| format!("{}", path.display()));
        let hashed = study.inputs().into_iter().map(|path| {
            let name = path.strip_prefix(folder).unwrap_or(&path).display().to_string();
            Ok((name, format!("{:016x}", fnv1a(&read(&path)?))))
        });
        let of_reference = reference_models.iter().map(|(body, path)| {
            Ok((format!("reference model of {body}"), format!("{:016x}", fnv1a(&read(path)?))))
        });
        Ok(Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            scene: String::from_utf8_lossy(&read(scene)?).into_owned(),
            inputs: hashed.chain(of_reference).collect::<Result<_>>()?,
            quantities: quantities.iter().map(Quantity::to_string).collect(),
            reference_tolerance,
        })
    }

    /// What is another in what was asked before; nothing if all is the same.
    pub fn difference(&self, before: &Self) -> Option<&'static str> {
        if self == before {
            None
        } else if before.version != self.version {
            Some("another version of the command")
        } else if before.scene != self.scene {
            Some("another scene")
        } else if before.inputs != self.inputs {
            Some("other models or tables")
        } else if before.quantities != self.quantities {
            Some("other quantities")
        } else {
            Some("another tolerance of the reference")
        }
    }
}

pub(super) fn fnv1a(bytes: &[u8]) -> u64 {
    bytes
        .iter()
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
}
