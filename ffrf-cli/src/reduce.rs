//! `ffrf reduce`: finite-element files to a reduced body.

use std::ffi::OsString;
use std::path::Path;

use anyhow::{Context, Error, Result, bail};
use clap::Parser;
use ffrf_fe::import::{read_square_matrix, source_file};
pub use ffrf_fe::modes::Progress;
use ffrf_fe::reduction::{Damping, MODE_SHAPES, MarkerRequest, ReductionOptions, reduce};
use ffrf_fe::{FeModel, ModeBasis, Nodes};
use ffrf_host::picture::Shape;
use ffrf_model::{CheckReport, ReducedBody};

use crate::animation::{body_glb, skin};
use crate::arguments::{Arguments, Command, MarkerArgument, Reduce};
use crate::fe_input::node_rows;
use crate::progress::Teller;
use crate::{component_modes, describe, fe_input, modes, output, section, stiffening, stress, view};

/// Hears what a reduction has to say; each text is a line or more, with their ends.
pub trait Listener {
    /// A report for people. Errors: it cannot be told, which ends the reduction.
    fn say(&mut self, text: &str) -> Result<()>;
    /// What was taken for granted or looks odd.
    fn warn(&mut self, text: &str);
    /// Where the computation of modes is.
    fn progress(&mut self, progress: Progress);
}

/// The terminal, where reports stand beside the result.
struct Terminal<'a> {
    result: &'a Path,
    teller: Option<Teller>,
}

impl Listener for Terminal<'_> {
    fn say(&mut self, text: &str) -> Result<()> {
        self.teller = None;
        output::say_beside(self.result, text)
    }

    fn warn(&mut self, text: &str) {
        self.teller = None;
        output::complain(text);
    }

    fn progress(&mut self, progress: Progress) {
        self.teller.get_or_insert_with(Teller::new).tell(progress);
    }
}

/// Runs the command.
pub fn run(arguments: &Reduce) -> Result<()> {
    let mut terminal = Terminal { result: &arguments.output, teller: None };
    let (body, checks) = reduced(arguments, &mut terminal)?;
    output::write(Some(&arguments.output), &body.to_json()?)?;
    terminal.say(&format!("\n{}\n{}", describe::body(&body), describe::checks(&checks)))?;
    terminal.say(&format!("written: {}\n", arguments.output.display()))
}

/// The body of the command line `ffrf reduce WORDS`, which is not written. Errors: as the command has them, wrong usage too.
pub fn from_words(
    words: impl IntoIterator<Item = OsString>,
    listener: &mut dyn Listener,
) -> Result<ReducedBody> {
    let command = ["ffrf", "reduce"].map(OsString::from);
    let parsed = Arguments::try_parse_from(command.into_iter().chain(words));
    match parsed.map_err(|error| Error::msg(usage(&error)))?.command {
        Command::Reduce(arguments) => Ok(reduced(&arguments, listener)?.0),
        _ => bail!("expected the words of `ffrf reduce`"),
    }
}

/// What is wrong with a command line, without what it is followed by on a terminal.
fn usage(error: &clap::Error) -> String {
    let text = error.render().to_string();
    let text = text.split("\n\nUsage:").next().unwrap_or_default();
    text.trim().trim_start_matches("error: ").to_owned()
}

/// Refuses names of pictures that end otherwise, before the work.
fn expect_names(arguments: &Reduce) -> Result<()> {
    if let Some(target) = &arguments.view {
        view::expect_ending(target, view::ENDINGS)?;
    }
    if let Some(target) = &arguments.sheet {
        view::expect_ending(target, &[".svg"])?;
    }
    Ok(())
}

/// The body that is asked for, and its checks, which it passes.
fn reduced(arguments: &Reduce, listener: &mut dyn Listener) -> Result<(ReducedBody, CheckReport)> {
    expect_names(arguments)?;
    let mut model = fe_input::read(&arguments.files, &mut |text| listener.warn(text))?;
    listener.say(&format!("{}\n", fe_input::describe(&model)))?;
    if let Some(remark) = arguments.files.body_units().and_then(fe_input::remark_on_time) {
        listener.say(&format!("{remark}\n"))?;
    }
    let mut options = options(arguments, &model.nodes)?;
    let (body, basis) = if arguments.interfaces.interfaces.is_empty() {
        with_eigenmodes(arguments, &mut model, &mut options, listener)?
    } else {
        let progress = &mut |progress| listener.progress(progress);
        let (body, basis, text) = component_modes::reduce(&model, arguments, &options, progress)?;
        listener.say(&format!("{text}\n"))?;
        (body, basis)
    };
    draw(arguments, &model, &basis, &body, listener)?;
    let checks = body.check()?;
    checks.verdict()?;
    Ok((body, checks))
}

/// The body with eigenmodes or the user's mode shapes, and its basis.
fn with_eigenmodes(
    arguments: &Reduce,
    model: &mut FeModel,
    options: &mut ReductionOptions,
    listener: &mut dyn Listener,
) -> Result<(ReducedBody, ModeBasis)> {
    let conversion = arguments.files.conversion();
    let progress = &mut |progress| listener.progress(progress);
    let solution = modes::solve(model, &arguments.choice, None, conversion, progress)?;
    if let Some(path) = &arguments.modal_stiffness {
        let mut stiffness = read_square_matrix(path, solution.basis.modes.len())?;
        if let Some(conversion) = conversion {
            conversion.modal_stiffness(&mut stiffness);
        }
        options.modal_stiffness = Some(stiffness);
    }
    let extra =
        [(MODE_SHAPES, &arguments.choice.mode_shapes), ("modal stiffness", &arguments.modal_stiffness)];
    for (role, path) in extra {
        if let Some(path) = path {
            model.sources.push(source_file(path, role)?);
        }
    }
    listener.say(&format!("{}\n", solution.report))?;
    let first = solution.report.modes.first().and_then(|mode| mode.frequency_hz);
    fe_input::warn_of_units(model, arguments.files.body_units(), first, &mut |text| listener.warn(text));
    let mut body = reduce(model, &solution.basis, options)?;
    let support = stiffening::support(model, &arguments.choice)?;
    stiffening::add(&mut body, model, &solution.basis, &support, &arguments.stiffening, conversion)?;
    stress::add(&mut body, model, &solution.basis, arguments)?;
    section::add(&mut body, model, &solution.basis, arguments)?;
    Ok((body, solution.basis))
}

/// Writes the pictures that are asked for.
fn draw(
    arguments: &Reduce,
    model: &FeModel,
    basis: &ModeBasis,
    body: &ReducedBody,
    listener: &mut dyn Listener,
) -> Result<()> {
    let wanted = [&arguments.surface, &arguments.view, &arguments.sheet];
    if wanted.iter().all(|target| target.is_none()) {
        return Ok(());
    }
    let surface = skin(model, basis)?;
    let mut said = |target: &Path| {
        let Shape { points, triangles, .. } = &surface.0;
        let text = format!(
            "surface of {} points, {} triangles; written: {}\n",
            points.len(),
            triangles.len(),
            target.display()
        );
        listener.say(&text)
    };
    if let Some(target) = &arguments.surface {
        output::write_bytes(target, &surface.encode()?)?;
        said(target)?;
    }
    if let Some(target) = &arguments.view {
        view::write(target, &body.title, &body_glb(body, &surface.0))?;
        said(target)?;
    }
    if let Some(target) = &arguments.sheet {
        output::write(Some(target), &view::draw_sheet(body, &surface.0)?)?;
        said(target)?;
    }
    Ok(())
}

fn options(arguments: &Reduce, nodes: &Nodes) -> Result<ReductionOptions> {
    let damping = match (&arguments.damping_ratio, arguments.rayleigh, &arguments.damping_bands) {
        (Some(ratios), ..) => Damping::ModalRatio(ratios.clone()),
        (None, Some((alpha, beta)), _) => Damping::Rayleigh { alpha, beta },
        (None, None, Some(bands)) => bands.clone(),
        (None, None, None) => Damping::None,
    };
    Ok(ReductionOptions {
        title: arguments.title.clone().unwrap_or_else(|| arguments.files.name()),
        units: arguments.files.body_units(),
        damping,
        markers: arguments.markers.iter().map(|marker| request(marker, nodes)).collect::<Result<_>>()?,
        modal_stiffness: None,
    })
}

fn request(marker: &MarkerArgument, nodes: &Nodes) -> Result<MarkerRequest> {
    let rows = node_rows(nodes, &marker.nodes).with_context(|| format!("--marker {}", marker.name))?;
    Ok(MarkerRequest { name: marker.name.clone(), nodes: rows })
}
