//! `ffrf export`: scenes for other tools.

mod library;

use std::fmt::Write as _;
use std::io::{Cursor, Write as _};

use anyhow::{Context, Result};
use ffrf_fmu::description::{Fmi, description, identifier};
use ffrf_fmu::{Model, Role};
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
    let (library, from) = library::find(arguments)?;
    let binary = format!("binaries/{}/{identifier}{}", library::platform(fmi), std::env::consts::DLL_SUFFIX);
    let text = description(&model, fmi, &name, &identifier);
    let mut files = vec![("modelDescription.xml".to_owned(), text.into_bytes()), (binary, library)];
    files.extend(model.files.iter().map(|(path, bytes)| (format!("resources/{path}"), bytes.clone())));
    output::write_bytes(&arguments.output, &archive(&files)?)?;
    let count = |is: fn(&Role) -> bool| model.variables.iter().filter(|variable| is(&variable.role)).count();
    let mut report = String::new();
    let _ = writeln!(
        report,
        "inputs: {}, outputs: {}, parameters: {}, other variables: {}\nlibrary: {}\nwritten: {}",
        count(|role| matches!(role, Role::Input(..))),
        count(|role| matches!(role, Role::Output(_))),
        count(|role| matches!(role, Role::Parameter(..))),
        count(|role| matches!(role, Role::Time | Role::Local(_))),
        from.display(),
        arguments.output.display()
    );
    output::say_beside(&arguments.output, &report)
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
