//! The page of results, and how much of it may differ on another machine.

use std::path::Path;
use std::{env, fs};

use crate::table::Section;

/// Set this to write the page anew; the test fails once, so that nobody forgets to read the difference.
const UPDATE: &str = "FFRF_UPDATE_EXTREMES";

/// A figure may differ by this factor from the page's: it has one digit, is mostly round-off, and another machine, compiler
/// or mathematical library rounds differently.
const ANOTHER_MACHINE: f64 = 30.0;

/// Figures below this are round-off of one operation or two, in double precision: nothing at all on one machine, a unit in the last
/// place on another.
const NOTHING: f64 = 1e-15;

const HEAD: &str = "# At the extremes

What holds where numbers are as large, as small or as unsuitable as they get, and what was measured there. Made by
`FFRF_UPDATE_EXTREMES=1 cargo test --test extremes`, which holds this page against what it measures: each figure below its
bound (the number behind `<`; reasons in `tests/extremes/tolerances.rs`) and within a factor of 30 of what stands here, each
message word for word. Everywhere: no panic, no state that is not finite without an error, work that ends.

";

/// The page of these sections.
fn page(sections: &[&Section]) -> String {
    let mut text = HEAD.to_owned();
    for section in sections {
        text.push_str(&section.to_string());
        text.push('\n');
    }
    text.truncate(text.trim_end().len());
    text.push('\n');
    text
}

/// The first words that differ by more than another machine may make them.
fn difference(expected: &str, found: &str) -> Option<String> {
    let (mut left, mut right) = (expected.split_whitespace(), found.split_whitespace());
    loop {
        match (left.next(), right.next()) {
            (None, None) => return None,
            (Some(a), Some(b)) if a == b || close(a, b) => {}
            (a, b) => {
                return Some(format!("page: {}\nfound: {}", start(a, left), start(b, right)));
            }
        }
    }
}

/// The first words of what is left of a page.
fn start<'a>(word: Option<&'a str>, rest: impl Iterator<Item = &'a str>) -> String {
    word.into_iter().chain(rest).take(12).collect::<Vec<_>>().join(" ")
}

fn close(a: &str, b: &str) -> bool {
    match (a.parse::<f64>(), b.parse::<f64>()) {
        (Ok(a), Ok(b)) if a.abs().max(b.abs()) < NOTHING => true,
        (Ok(a), Ok(b)) if a != 0.0 && b != 0.0 => {
            a.signum() == b.signum() && (a / b).abs().ln().abs() <= ANOTHER_MACHINE.ln()
        }
        _ => false,
    }
}

/// Holds the page against the sections.
pub fn compare(sections: &[&Section]) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/extremes.md");
    let found = page(sections);
    let expected = fs::read_to_string(&path).unwrap_or_default();
    let Some(difference) = difference(&expected, &found) else { return };
    if env::var_os(UPDATE).is_some() {
        fs::write(&path, found).unwrap();
        panic!("docs/extremes.md is written anew: read the difference and run again without {UPDATE}");
    }
    panic!("docs/extremes.md is stale, renew it with {UPDATE}=1:\n{difference}");
}

#[test]
fn pages_differ_by_words_and_by_orders_of_magnitude() {
    let page = "| case | 3e-12 < 1e-9 | refused: joint `a` |";
    assert_eq!(difference(page, page), None);
    assert_eq!(difference(page, "| case | 8e-12 < 1e-9 | refused: joint `a` |"), None);
    assert_eq!(difference("| 2e-16 < 1e-9 |", "| 0 < 1e-9 |"), None);
    for other in [
        "| case | 3e-10 < 1e-9 | refused: joint `a` |",
        "| case | -3e-12 < 1e-9 | refused: joint `a` |",
        "| case | 0 < 1e-9 | refused: joint `a` |",
        "| case | 3e-12 < 1e-9 | refused: joint `b` |",
        "| case | 3e-12 < 1e-9 | refused: joint `a`",
    ] {
        assert!(difference(page, other).is_some(), "{other}");
    }
}
