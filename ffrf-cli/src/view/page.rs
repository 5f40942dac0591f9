//! A model in glTF's binary form as one page: the model, what draws it, and three.js, all in it.

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;

use crate::markup::escaped;

const THREE: &str = include_str!("../../vendor/three/three.min.js");
const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

/// The page. `name`: of the file, for its title bar.
pub fn html(name: &str, glb: &[u8]) -> String {
    let name = escaped(name);
    let model = BASE64_STANDARD.encode(glb);
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{name}</title>\n\
         <style>\n{STYLE}</style>\n</head>\n<body>\n<div id=\"view\"></div>\n<aside id=\"panel\"></aside>\n\
         <script id=\"model\" type=\"text/plain\">{model}</script>\n<script>{THREE}</script>\n\
         <script>\n{SCRIPT}</script>\n</body>\n</html>\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_ends_a_script_before_its_end() {
        for script in [THREE, SCRIPT] {
            assert!(!script.contains("</script"));
        }
    }
}
