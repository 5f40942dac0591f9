//! `ffrf export`: scenes for other tools.

mod compile;
mod library;

use std::fmt::Write as _;
use std::io::{Cursor, Write as _};

use anyhow::{Context, Result};
use ffrf_fmu::description::{Fmi, description, identifier};
use ffrf_fmu::{Model, Role, Sources};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

use crate::arguments::{Export, ExportFmu, ExportFormat, FmiVersion};
use crate::output;

/// Runs the command.
pub fn run(arguments: &Export) -> Result<()> {
    match &arguments.format {
        ExportFormat::Fmu(arguments) => fmu(arguments),
    }
}

fn fmu(arguments: &ExportFmu) -> Result<()> {
    let path = &arguments.scene;
    let model = Model::of_scene(path).with_context(|| format!("{}", path.display()))?;
    let name = arguments.name.clone().unwrap_or_else(|| {
        path.file_stem().map_or_else(|| "scene".to_owned(), |stem| stem.to_string_lossy().into_owned())
    });
    let identifier = identifier(&name);
    let fmi = match arguments.fmi {
        FmiVersion::Two => Fmi::Two,
        FmiVersion::Three => Fmi::Three,
    };
    let contents = if arguments.c_sources {
        with_sources(&model, fmi, &identifier, arguments.compiler.as_deref())
            .with_context(|| format!("{}", path.display()))?
    } else {
        with_library(&model, fmi, &identifier, arguments)?
    };
    let text = description(&model, fmi, &name, &identifier, contents.sources.as_ref());
    let mut files = vec![("modelDescription.xml".to_owned(), text.into_bytes())];
    files.extend(contents.files);
    output::write_bytes(&arguments.output, &archive(&files)?)?;
    let count = |is: fn(&Role) -> bool| model.variables.iter().filter(|variable| is(&variable.role)).count();
    let mut report = String::new();
    let _ = writeln!(
        report,
        "inputs: {}, outputs: {}, parameters: {}, other variables: {}\n{}\nwritten: {}",
        count(|role| matches!(role, Role::Input(..))),
        count(|role| matches!(role, Role::Output(_))),
        count(|role| matches!(role, Role::Parameter(..))),
        count(|role| matches!(role, Role::Time | Role::Local(_))),
        contents.report,
        arguments.output.display()
    );
    output::say_beside(&arguments.output, &report)
}

/// What an FMU holds besides its description.
struct Contents {
    files: Vec<(String, Vec<u8>)>,
    sources: Option<Sources>,
    /// A line for people.
    report: String,
}

/// The library of ffrf and the files of the scene. Errors: there is no library of this version.
fn with_library(model: &Model, fmi: Fmi, identifier: &str, arguments: &ExportFmu) -> Result<Contents> {
    let (library, from) = library::find(arguments)?;
    let mut files = vec![(library::place(fmi, identifier), library)];
    files.extend(model.files.iter().map(|(path, bytes)| (format!("resources/{path}"), bytes.clone())));
    Ok(Contents { files, sources: None, report: format!("library: {}", from.display()) })
}

/// The step of the mechanism in C, and a binary made of it where there is a compiler.
///
/// Errors: the scene has something that generated C has not; the compiler cannot be run or refuses the sources.
fn with_sources(model: &Model, fmi: Fmi, identifier: &str, compiler: Option<&str>) -> Result<Contents> {
    let sources = model
        .c_sources(fmi, identifier)
        .context("--c-sources (without it, an FMU with ffrf's own library simulates every scene)")?;
    let mut files = Vec::new();
    let made = match compile::compile(&sources, compiler)? {
        Some((binary, compiler)) => {
            files.push((library::place(fmi, identifier), binary));
            format!("binary by {compiler}")
        }
        None => "no binary: no compiler was found or asked for".to_owned(),
    };
    let texts = sources.files.iter();
    files.extend(texts.map(|(name, text)| (format!("sources/{name}"), text.clone().into_bytes())));
    let report = format!("C sources: {} files, {made}", sources.files.len());
    Ok(Contents { files, sources: Some(sources), report })
}

/// The same files give the same bytes: no time of day goes in.
fn archive(files: &[(String, Vec<u8>)]) -> Result<Vec<u8>> {
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Deflated)
        .last_modified_time(DateTime::default());
    for (name, bytes) in files {
        writer.start_file(name.as_str(), options).with_context(|| name.clone())?;
        writer.write_all(bytes).with_context(|| name.clone())?;
    }
    Ok(writer.finish()?.into_inner())
}
