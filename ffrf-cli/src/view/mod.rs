//! `ffrf view`: a body with its modes, or a motion, as one page for a browser; modes side by side for documents.

mod page;
mod projection;
mod sheet;

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail};
use ffrf_host::picture::{Shape, model_skeleton};
use ffrf_model::ReducedBody;

use crate::animation::{Surface, body_glb};
use crate::arguments::View;
use crate::output;

use page::html;
pub use sheet::draw as draw_sheet;

/// First bytes of a file in glTF's binary form.
const GLB: &[u8] = b"glTF";

/// Endings of names of what is seen in a browser.
pub const ENDINGS: &[&str] = &[".html", ".glb"];

/// Runs the command.
pub fn run(arguments: &View) -> Result<()> {
    let path = &arguments.input;
    if let Some(target) = &arguments.output {
        expect_ending(target, ENDINGS)?;
    }
    if let Some(target) = &arguments.sheet {
        expect_ending(target, &[".svg"])?;
    }
    let bytes = fs::read(path).with_context(|| format!("{}", path.display()))?;
    let model = if bytes.starts_with(GLB) {
        for (given, option) in [(&arguments.surface, "--surface"), (&arguments.sheet, "--sheet")] {
            if given.is_some() {
                bail!("{}: {option} is for a reduced body, and this is a motion", path.display());
            }
        }
        bytes
    } else {
        let body = ReducedBody::read(path).with_context(|| {
            format!("{}: expected a reduced body (.ffrf.json) or a motion (.glb)", path.display())
        })?;
        let shape = shape(&body, arguments.surface.as_deref())?;
        if let Some(target) = &arguments.sheet {
            if arguments.surface.is_none() {
                bail!(
                    "--sheet needs the surface of the part: --surface, which `ffrf reduce --surface` writes"
                );
            }
            write_sheet(target, &body, &shape)?;
        }
        body_glb(&body, &shape)
    };
    match &arguments.output {
        Some(target) => {
            let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
            write(target, &name, &model)?;
            output::say_beside(target, &format!("written: {}\n", target.display()))
        }
        None => Ok(()),
    }
}

/// What a body looks like: its surface if there is one.
fn shape(body: &ReducedBody, surface: Option<&Path>) -> Result<Shape> {
    match surface {
        Some(surface) => Ok(Surface::read(surface, body.modes.len())?.0),
        None => Ok(model_skeleton(body)),
    }
}

fn write_sheet(target: &Path, body: &ReducedBody, shape: &Shape) -> Result<()> {
    output::write(Some(target), &draw_sheet(body, shape)?)?;
    output::say_beside(target, &format!("written: {}\n", target.display()))
}

/// Writes a model in glTF's binary form as a page, or as it is, as the name of the file says.
pub fn write(target: &Path, name: &str, glb: &[u8]) -> Result<()> {
    if target.to_string_lossy().ends_with(".glb") {
        return output::write_bytes(target, glb);
    }
    output::write(Some(target), &html(name, glb))
}

/// Refuses a name that ends otherwise.
pub fn expect_ending(path: &Path, endings: &[&str]) -> Result<()> {
    let name = path.to_string_lossy();
    if endings.iter().any(|ending| name.ends_with(ending)) {
        return Ok(());
    }
    bail!("{}: expected a name that ends in {}", path.display(), endings.join(" or "))
}
