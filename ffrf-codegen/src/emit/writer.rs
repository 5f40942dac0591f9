//! Lines with their indentation.

use crate::emit::units::UnitNames;

/// Width of generated lines.
pub(super) const LINE_WIDTH: usize = 110;

/// Text that grows line by line.
#[derive(Debug, Clone)]
pub(super) struct Writer {
    text: String,
    depth: usize,
    units: UnitNames,
}

impl Writer {
    /// No text yet; documentation will name these units.
    pub(super) fn new(units: UnitNames) -> Self {
        Self { text: String::new(), depth: 0, units }
    }

    /// The text.
    pub(super) fn finish(self) -> String {
        self.text
    }

    /// A line, or several, each indented.
    pub(super) fn line(&mut self, text: impl AsRef<str>) {
        for line in text.as_ref().lines() {
            if !line.trim_end().is_empty() {
                self.text.push_str(&"    ".repeat(self.depth));
                self.text.push_str(line.trim_end());
            }
            self.text.push('\n');
        }
    }

    /// An empty line.
    pub(super) fn blank(&mut self) {
        self.text.push('\n');
    }

    /// Lines of documentation, written in SI units.
    pub(super) fn documentation<S: AsRef<str>>(&mut self, lines: impl IntoIterator<Item = S>) {
        for line in lines {
            self.line(format!("/// {}", self.in_units(line.as_ref())));
        }
    }

    /// A line of documentation written in SI units, in those of the body.
    pub(super) fn in_units(&self, line: &str) -> String {
        self.units.replace_in(line)
    }

    /// What follows stands one level deeper.
    pub(super) fn indent(&mut self) {
        self.depth += 1;
    }

    /// What follows stands one level less deep.
    pub(super) fn outdent(&mut self) {
        self.depth = self.depth.saturating_sub(1);
    }

    /// `open`, then what `write` writes, one level deeper, then `close`.
    pub(super) fn block(&mut self, open: &str, close: &str, write: impl FnOnce(&mut Self)) {
        self.line(open);
        self.depth += 1;
        write(self);
        self.depth -= 1;
        self.line(close);
    }

    /// A function: its head on one line if it fits and `may_be_short`, else one argument a line; then its body.
    pub(super) fn function(&mut self, head: &FunctionHead<'_>, body: impl FnOnce(&mut Self)) {
        self.prefixed_function("", head, body);
    }

    /// [`function`](Self::function) with a visibility before it.
    pub(super) fn prefixed_function(
        &mut self,
        prefix: &str,
        head: &FunctionHead<'_>,
        body: impl FnOnce(&mut Self),
    ) {
        let FunctionHead { name, inputs, result, may_be_short } = head;
        let arrow = if result.is_empty() { String::new() } else { format!(" -> {result}") };
        let short = format!("{prefix}fn {name}({}){arrow} {{", inputs.join(", "));
        if *may_be_short && short.len() <= LINE_WIDTH - 4 {
            self.line(short);
        } else {
            self.line(format!("{prefix}fn {name}("));
            self.depth += 1;
            for input in *inputs {
                self.line(format!("{input},"));
            }
            self.depth -= 1;
            self.line(format!("){arrow} {{"));
        }
        self.depth += 1;
        body(self);
        self.depth -= 1;
        self.line("}");
    }
}

/// What stands before the body of a function.
pub(super) struct FunctionHead<'a> {
    /// Name with generics.
    pub(super) name: &'a str,
    /// Arguments with their types.
    pub(super) inputs: &'a [String],
    /// Type of the result, empty if there is none.
    pub(super) result: &'a str,
    /// Whether it may stand on one line.
    pub(super) may_be_short: bool,
}

/// `[a, b, c]` on one line if it fits beside what is `taken` of the line, else several entries a line.
pub(super) fn bracketed(entries: &[String], taken: usize) -> String {
    let single = format!("[{}]", entries.join(", "));
    if taken + single.len() <= LINE_WIDTH - 16 {
        return single;
    }
    format!("[\n    {}\n]", filled(entries, LINE_WIDTH - 23).join("\n    "))
}

/// The entries, each with a comma behind it, on as few lines as hold at most `most` characters before the last comma.
pub(super) fn filled(entries: &[String], most: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for entry in entries {
        match lines.last_mut() {
            Some(line) if line.len() + entry.len() <= most => {
                line.push(' ');
                line.push_str(entry);
                line.push(',');
            }
            _ => lines.push(format!("{entry},")),
        }
    }
    lines
}
