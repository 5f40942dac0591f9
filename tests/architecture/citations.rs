//! Files that comments and documents name are there.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::workspace::{package_of, root, source_files, text_files};

/// What a cited path ends in; names without such an end, and of other formats, are examples.
const ENDS: [&str; 4] = [".rs", ".md", ".toml", ".svg"];

/// Folders that a citation may be relative to, besides that of the file that cites.
const STARTS: [&str; 5] = ["", "docs", "docs/theory", "tests", "benches"];

/// What is named as a thing that a user has or makes, or that lies beside this repository.
const ELSEWHERE: [&str; 2] = ["../shared/", "target/"];

#[test]
fn cited_files_exist() {
    let names = known_names();
    let mut offences = Vec::new();
    for path in source_files().into_iter().chain(text_files()) {
        let text = fs::read_to_string(&path).expect("readable file");
        let shown = path.strip_prefix(root()).unwrap_or(&path).display().to_string();
        let is_code = path.extension().is_some_and(|extension| extension == "rs");
        for (number, line) in text.lines().enumerate() {
            let line = if is_code { comment(line) } else { line };
            for cited in citations(line, is_code).filter(|cited| !exists(cited, &path, &names)) {
                offences.push(format!("{shown}:{}: there is no `{cited}`", number + 1));
            }
        }
    }
    assert!(offences.is_empty(), "{}", offences.join("\n"));
}

/// The comment of a line of code.
fn comment(line: &str) -> &str {
    let line = line.trim_start();
    if line.starts_with("//") { line } else { line.split_once(" // ").map_or("", |(_, comment)| comment) }
}

/// Paths in a line: with a folder or in capitals in comments, where `body.rs` may be anybody's; in documents only
/// targets of links and paths in backquotes.
fn citations(line: &str, is_code: bool) -> impl Iterator<Item = &str> {
    let separators: &[char] = if is_code {
        &[' ', '`', '(', ')', '[', ']', ',', ';', ':', '"', '\'', '|', '<', '>', '=']
    } else {
        &['`', '(', ')', ' ']
    };
    line.split(separators).map(|word| word.trim_end_matches('.')).filter(move |word| {
        let cited = word.split('#').next().unwrap_or(word);
        let named = ENDS.iter().any(|end| cited.len() > end.len() && cited.ends_with(end));
        let stem = cited.rsplit_once('.').map_or(cited, |(stem, _)| stem);
        let capitals = stem.chars().all(|c| c.is_ascii_uppercase() || c == '_') && cited.ends_with(".md");
        let pattern = cited.contains(['*', '{', '$', '…']) || cited.contains("://");
        named && !pattern && (cited.contains('/') || capitals)
    })
}

fn exists(cited: &str, by: &Path, names: &BTreeSet<String>) -> bool {
    let cited = cited.split('#').next().unwrap_or(cited);
    if ELSEWHERE.iter().any(|start| cited.contains(start)) {
        return true;
    }
    let beside = by.parent().unwrap_or(root()).join(cited);
    let package = package_of(by);
    beside.exists()
        || STARTS.iter().any(|start| root().join(start).join(cited).exists())
        || [package.join(cited), package.join("src").join(cited)].iter().any(|path| path.exists())
        // `rust/structure.rs`: the end of a path, when the sentence says the rest.
        || names.iter().any(|name| name.ends_with(&format!("/{cited}")))
}

fn known_names() -> BTreeSet<String> {
    let shown = |path: PathBuf| path.strip_prefix(root()).unwrap_or(&path).to_string_lossy().into_owned();
    source_files().into_iter().chain(text_files()).map(shown).collect()
}
