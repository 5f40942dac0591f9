//! Text from files and command lines, as messages and reports quote it.

/// The text on one line, with control characters as `\u{1b}`, and those that reverse the direction of writing as well: no
/// file can steer the terminal that it is shown on, or add lines of its own to a report.
pub fn printable(text: &str) -> String {
    let mut printable = String::with_capacity(text.len());
    for character in text.chars() {
        let turns = matches!(character, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
        let breaks = matches!(character, '\u{2028}' | '\u{2029}');
        if turns || breaks || character.is_control() {
            printable.extend(character.escape_unicode());
        } else {
            printable.push(character);
        }
    }
    printable
}

#[cfg(test)]
mod tests {
    use super::printable;

    #[test]
    fn control_characters_are_shown_and_not_obeyed() {
        let text = "a\u{1b}[31m\r\u{9b}2J\u{7f}\u{202e}\tb\n\u{2028}Ä²";
        assert_eq!(printable(text), "a\\u{1b}[31m\\u{d}\\u{9b}2J\\u{7f}\\u{202e}\\u{9}b\\u{a}\\u{2028}Ä²");
    }
}
