//! Lines and comments of C.

use crate::emit::units::UnitNames;
use crate::emit::writer::{LINE_WIDTH, Writer, filled};

/// Text that grows line by line.
#[derive(Debug)]
pub(super) struct Text {
    writer: Writer,
}

impl Text {
    /// No text yet; documentation will name these units.
    pub(super) fn new(units: UnitNames) -> Self {
        Self { writer: Writer::new(units) }
    }

    /// The text.
    pub(super) fn finish(self) -> String {
        self.writer.finish()
    }

    /// A line, or several; an empty one at the end counts.
    pub(super) fn line(&mut self, text: impl AsRef<str>) {
        self.writer.line(&text);
        if text.as_ref().ends_with('\n') {
            self.writer.blank();
        }
    }

    /// An empty line.
    pub(super) fn blank(&mut self) {
        self.writer.blank();
    }

    /// `open`, then what `write` writes, one level deeper, then `close`.
    pub(super) fn block(&mut self, open: &str, close: &str, write: impl FnOnce(&mut Self)) {
        self.writer.line(open);
        self.writer.indent();
        write(self);
        self.writer.outdent();
        self.line(close);
    }

    /// Documentation, written in SI units.
    pub(super) fn documentation(&mut self, lines: impl IntoIterator<Item = String>) {
        let lines: Vec<String> = lines.into_iter().map(|line| self.writer.in_units(&line)).collect();
        self.comment(lines);
    }

    /// A comment of several lines.
    pub(super) fn comment(&mut self, lines: impl IntoIterator<Item = String>) {
        let lines: Vec<String> = lines.into_iter().map(|line| harmless(&line)).collect();
        match lines.as_slice() {
            [line] => self.line(format!("/* {line} */")),
            lines => {
                self.line("/*");
                for line in lines {
                    self.line(format!(" * {line}"));
                }
                self.line(" */");
            }
        }
    }
}

/// Text that neither ends a comment nor begins one, and holds no trigraph.
pub(super) fn harmless(line: &str) -> String {
    line.replace("*/", "* /").replace("/*", "/ *").replace("??", "? ?")
}

/// `{a, b, c}`, several entries a line.
pub(super) fn braced(entries: &[String]) -> String {
    let lines = filled(entries, LINE_WIDTH - 21).join("\n    ");
    let lines = lines.trim_end_matches(',');
    if lines.contains('\n') { format!("{{\n    {lines}\n}}") } else { format!("{{{lines}}}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_end_where_they_should() {
        let mut text = Text::new(UnitNames::of(None));
        text.comment(["a */ int x; /* what??/".to_owned()]);
        assert_eq!(text.finish(), "/* a * / int x; / * what? ?/ */\n");
    }

    #[test]
    fn long_lists_are_broken() {
        let entries: Vec<String> = (0..40).map(|k| format!("{k}.0")).collect();
        let text = braced(&entries);
        assert!(text.lines().count() > 2 && text.lines().all(|line| line.len() < 100), "{text}");
        assert_eq!(text.matches(',').count(), 39);
        assert_eq!(braced(&entries[..2]), "{0.0, 1.0}");
    }
}
