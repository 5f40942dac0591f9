//! Text inside of HTML and SVG.

/// Text as it stands between the marks of an element.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
