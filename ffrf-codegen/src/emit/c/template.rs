//! Statements that are written once as C: the parts that a body or mechanism needs, with its names.

use std::collections::BTreeSet;

/// Begins lines that are left out unless there is what they name.
const BEGIN: &str = "//@ if ";
/// Ends them.
const END: &str = "//@ end";

/// The statements of a template for what is in `features`, with names in the place of others, one replacement after the other.
pub(super) fn filled(template: &str, features: &BTreeSet<&str>, names: &[(&str, &str)]) -> String {
    let mut text = String::new();
    let mut open: Vec<bool> = Vec::new();
    for line in template.lines() {
        if let Some(feature) = line.strip_prefix(BEGIN) {
            open.push(features.contains(feature));
        } else if line == END {
            open.pop();
        } else if open.iter().all(|open| *open) {
            let line = names.iter().fold(line.to_owned(), |line, (place, name)| line.replace(place, name));
            text.push_str(&line);
            text.push('\n');
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_needed_is_left_out() {
        let template = "a\n//@ if X\nb\n//@ if Y\nc\n//@ end\nd\n//@ end\n@P_e\n";
        let filled = |features: &[&'static str]| {
            filled(template, &features.iter().copied().collect(), &[("@P", "rod")])
        };
        assert_eq!(filled(&[]), "a\nrod_e\n");
        assert_eq!(filled(&["X"]), "a\nb\nd\nrod_e\n");
        assert_eq!(filled(&["Y"]), "a\nrod_e\n");
        assert_eq!(filled(&["X", "Y"]), "a\nb\nc\nd\nrod_e\n");
    }
}
