//! Committed texts against what is generated now.
#![allow(clippy::unwrap_used)] // helpers of tests are tests

use std::path::Path;

/// Set to rewrite the committed files.
const UPDATE: &str = "FFRF_UPDATE_GOLDEN";

/// Files of `tests/golden` that are not what is generated.
#[derive(Default)]
pub struct Committed {
    stale: Vec<String>,
}

impl Committed {
    /// Compares a file with what is generated now.
    pub fn compare(&mut self, name: &str, text: &str) {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden").join(name);
        self.note(name, std::fs::read_to_string(&path).unwrap_or_default() == text, || {
            std::fs::write(&path, text).unwrap();
        });
    }

    /// Notes whether a file is up to date, which `write` makes it.
    pub fn note(&mut self, name: &str, is_current: bool, write: impl FnOnce()) {
        if !is_current {
            self.stale.push(name.to_owned());
            if std::env::var_os(UPDATE).is_some() {
                write();
            }
        }
    }

    /// Fails if a file was stale.
    pub fn assert_current(&self) {
        let stale = &self.stale;
        assert!(
            stale.is_empty(),
            "stale: {stale:?}; run `{UPDATE}=1 cargo test -p ffrf --test generated_code` and read the difference"
        );
    }
}
