//! Errors as the user sees them.

/// The error and its causes, outermost first, one per line.
///
/// A cause that its consequence already quotes in full is not repeated.
pub fn chain(error: &anyhow::Error) -> String {
    let mut text = String::new();
    for cause in error.chain() {
        let message = cause.to_string();
        if text.is_empty() {
            text = message;
        } else if !text.ends_with(&message) {
            text.push_str("\n  caused by: ");
            text.push_str(&message);
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use anyhow::Context;

    #[test]
    fn a_quoted_cause_is_not_repeated() {
        let io = || std::io::Error::other("disk full");
        let quoted = Err::<(), _>(io()).context("body.json: disk full").unwrap_err();
        assert_eq!(super::chain(&quoted), "body.json: disk full");
        let plain = Err::<(), _>(io()).context("body.json").unwrap_err();
        assert_eq!(super::chain(&plain), "body.json\n  caused by: disk full");
    }
}
