//! `ffrf convert`: bodies to and from the formats of other multibody programs.

use std::path::Path;

use anyhow::{Result, bail};
use ffrf_fe::export::mbdyn::mbdyn_text;
use ffrf_fe::export::sid::sid_text;
use ffrf_fe::import::{read_mbdyn, read_sid};
use ffrf_model::{ReducedBody, SecondOrderTerms};

use crate::arguments::Convert;
use crate::{describe, output};

/// What a body can be converted to and from.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Format {
    /// MBDyn's modal data, `.fem`.
    Mbdyn,
    /// Standard input data, `.SID_FEM` or `.sid`.
    Sid,
}

impl Format {
    fn of(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_str()?.to_ascii_lowercase();
        match extension.as_str() {
            "fem" => Some(Self::Mbdyn),
            "sid_fem" | "sid" => Some(Self::Sid),
            _ => None,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Mbdyn => "MBDyn's format",
            Self::Sid => "standard input data",
        }
    }
}

/// Runs the command.
pub fn run(arguments: &Convert) -> Result<()> {
    let say = |text: &str| output::say_beside(&arguments.output, text);
    match (Format::of(&arguments.input), Format::of(&arguments.output)) {
        (Some(format), None) => {
            let body = match format {
                Format::Mbdyn => read_mbdyn(&arguments.input, arguments.units)?,
                Format::Sid => read_sid(&arguments.input, arguments.units)?,
            };
            let checks = body.check()?;
            output::write(Some(&arguments.output), &body.to_json()?)?;
            for note in &body.provenance.notes {
                say(&format!("note: {note}\n"))?;
            }
            say(&format!("{}\n{}", describe::body(&body), describe::checks(&checks)))?;
        }
        (None, Some(format)) => {
            let body = ReducedBody::read(&arguments.input)?;
            if body.markers.is_empty() {
                bail!(
                    "{} has no marker: the nodes of {} are the markers of the body",
                    arguments.input.display(),
                    format.name()
                );
            }
            if format == Format::Mbdyn && body.second_order_terms != SecondOrderTerms::Known {
                bail!(
                    "{} does not hold invariant I9, which MBDyn's format asks for: it was read from integrals \
                     that lack it",
                    arguments.input.display()
                );
            }
            let text = match format {
                Format::Mbdyn => mbdyn_text(&body),
                Format::Sid => sid_text(&body),
            };
            output::write(Some(&arguments.output), &text)?;
            let mut left_out = Vec::new();
            if format == Format::Mbdyn && body.geometric_stiffness.is_some() {
                left_out.push("geometric stiffness");
            }
            if !body.stress_markers.is_empty() {
                left_out.push("stress markers");
            }
            if !body.section_markers.is_empty() {
                left_out.push("section markers");
            }
            if body.geometric_stiffness.as_ref().is_some_and(|it| !it.marker_loads.is_empty()) {
                left_out.push("stress stiffness of loads at markers");
            }
            if !left_out.is_empty() {
                output::complain(&format!(
                    "note: no place in {} for {}: left out\n",
                    format.name(),
                    left_out.join(" and ")
                ));
            }
        }
        _ => bail!(
            "expected a body (*.ffrf.json) and a file of MBDyn (*.fem) or standard input data (*.SID_FEM, *.sid), one to \
             read and the other to write"
        ),
    }
    say(&format!("written: {}\n", arguments.output.display()))
}
