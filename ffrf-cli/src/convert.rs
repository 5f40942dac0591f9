//! `ffrf convert`: bodies to and from the formats of other multibody programs.

use std::path::Path;

use anyhow::{Result, bail};
use ffrf_fe::export::mbdyn::mbdyn_text;
use ffrf_fe::import::read_mbdyn;
use ffrf_model::ReducedBody;

use crate::arguments::Convert;
use crate::{describe, output};

/// Runs the command.
pub fn run(arguments: &Convert) -> Result<()> {
    let say = |text: &str| output::say_beside(&arguments.output, text);
    let is_mbdyn =
        |path: &Path| path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("fem"));
    match (is_mbdyn(&arguments.input), is_mbdyn(&arguments.output)) {
        (true, false) => {
            let body = read_mbdyn(&arguments.input, arguments.units)?;
            let checks = body.check()?;
            output::write(Some(&arguments.output), &body.to_json()?)?;
            for note in &body.provenance.notes {
                say(&format!("note: {note}\n"))?;
            }
            say(&format!("{}\n{}", describe::body(&body), describe::checks(&checks)))?;
        }
        (false, true) => {
            let body = ReducedBody::read(&arguments.input)?;
            if body.markers.is_empty() {
                bail!(
                    "{} has no marker: the nodes of MBDyn's modal joint are the markers of the body",
                    arguments.input.display()
                );
            }
            output::write(Some(&arguments.output), &mbdyn_text(&body))?;
            if body.geometric_stiffness.is_some() || !body.stress_markers.is_empty() {
                output::complain(
                    "note: geometric stiffness and stress markers have no place in MBDyn's format and are left out\n",
                );
            }
        }
        _ => bail!(
            "expected a body (*.ffrf.json) and a file of MBDyn (*.fem), one to read and the other to write"
        ),
    }
    say(&format!("written: {}\n", arguments.output.display()))
}
