//! Keyword lines: `*NAME, PARAMETER=value, FLAG`, continued after a comma at the line end.

/// One keyword with its parameters.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Keyword {
    /// Upper case, single blanks: `MATRIX GENERATE`.
    pub(super) name: String,
    parameters: Vec<(String, String)>,
}

impl Keyword {
    /// Parses the text between the asterisk and the end of the (continued) line.
    pub(super) fn parse(text: &str) -> Self {
        let mut fields = text.split(',').map(str::trim);
        let name = fields.next().unwrap_or_default();
        let parameters = fields.filter(|field| !field.is_empty()).map(|field| {
            let (key, value) = field.split_once('=').unwrap_or((field, ""));
            (key.trim().to_uppercase(), value.trim().trim_matches('"').to_owned())
        });
        Keyword {
            name: name.split_whitespace().collect::<Vec<_>>().join(" ").to_uppercase(),
            parameters: parameters.collect(),
        }
    }

    /// Value of a parameter; empty for a flag.
    pub(super) fn get(&self, key: &str) -> Option<&str> {
        self.parameters.iter().find(|(known, _)| known == key).map(|(_, value)| value.as_str())
    }

    pub(super) fn has(&self, key: &str) -> bool {
        self.get(key).is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::Keyword;

    #[test]
    fn case_and_blanks_do_not_matter() {
        let keyword = Keyword::parse("Solid  section , ELSET = Set-1, Generate,");
        assert_eq!(keyword.name, "SOLID SECTION");
        assert_eq!(keyword.get("ELSET"), Some("Set-1"));
        assert!(keyword.has("GENERATE") && !keyword.has("MATERIAL"));
    }
}
