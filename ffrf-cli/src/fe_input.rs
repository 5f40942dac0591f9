//! The finite-element model that the command line names.

use std::fmt::Write;
use std::path::Path;

use anyhow::{Result, bail};
use ffrf_fe::import::{Import, ImportOptions, ModelFiles, NodeSource, read_model_with};
use ffrf_fe::units::{Conversion, implausible};
use ffrf_fe::{FeModel, Nodes};
use ffrf_model::{Units, printable};

use crate::arguments::FeFiles;

impl FeFiles {
    /// File name of the node table, without its folder and extension.
    pub fn name(&self) -> String {
        let paths = [&self.mesh, &self.nodes, &self.abaqus, &self.calculix, &self.nastran, &self.ansys];
        let path = paths.into_iter().find_map(Option::as_deref);
        path.and_then(Path::file_stem).map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default()
    }

    /// The conversion that is asked for.
    pub fn conversion(&self) -> Option<Conversion> {
        Some(Conversion::new(self.units.as_ref()?, self.convert_to.as_ref()?))
    }

    /// The units of the body.
    pub fn body_units(&self) -> Option<Units> {
        self.convert_to.or(self.units)
    }

    fn node_source(&self) -> Result<NodeSource> {
        if let Some(path) = &self.mesh {
            return Ok(NodeSource::Mesh { path: path.clone(), materials: self.materials.clone() });
        }
        Ok(match (&self.nodes, &self.abaqus, &self.calculix, &self.nastran, &self.ansys) {
            (Some(path), ..) => match path.extension().and_then(|extension| extension.to_str()) {
                Some("npy" | "npz") => NodeSource::Numpy(path.clone()),
                _ => NodeSource::Text(path.clone()),
            },
            (_, Some(deck), ..) => NodeSource::Abaqus(deck.clone()),
            (_, _, Some(deck), ..) => NodeSource::Calculix(deck.clone()),
            (.., Some(deck), _) => NodeSource::Nastran(deck.clone()),
            (.., Some(nodes)) => NodeSource::Ansys { nodes: nodes.clone(), mapping: self.mapping.clone() },
            _ => bail!("give a mesh, or one of --nodes, --abaqus, --calculix, --nastran, --ansys"),
        })
    }
}

/// Reads and checks the model, and converts it if that is asked for. Remarks go to `warn`, each with its line's end.
pub fn read(files: &FeFiles, warn: &mut dyn FnMut(&str)) -> Result<FeModel> {
    let options = ImportOptions {
        mass_form: files.mass_form,
        allow_massless: files.allow_massless,
        inflated_limit: files.inflated_limit,
    };
    let conversion = files.conversion();
    let files = ModelFiles {
        nodes: files.node_source()?,
        mass: files.mass.clone(),
        stiffness: files.stiffness.clone(),
    };
    let Import { mut model, notes } = read_model_with(&files, &options)?;
    for note in &notes {
        warn(&format!("{note}\n"));
    }
    if let Some(conversion) = conversion {
        conversion.model(&mut model);
    }
    Ok(model)
}

/// Warns of numbers that no solid has in the units of the body.
pub fn warn_of_units(
    model: &FeModel,
    units: Option<Units>,
    frequency: Option<f64>,
    warn: &mut dyn FnMut(&str),
) {
    for remark in implausible(model, units, frequency) {
        warn(&format!("warning: {remark}\n"));
    }
}

/// What frequencies in tables are in, where the unit of time is not the second.
pub fn remark_on_time(units: Units) -> Option<String> {
    let time = units.time_name();
    (units.time() != 1.0).then(|| {
        format!("the unit of time is {time}: read Hz in the tables of modes as cycles per {time}; the body holds hertz")
    })
}

/// What was found in the files, in a few lines.
pub fn describe(model: &FeModel) -> String {
    let mut text = format!("{} nodes", model.nodes.len());
    if !model.elements.is_empty() {
        let _ = write!(text, ", {} elements", model.elements.len());
    }
    let _ = write!(text, "; mass matrix with {} entries", model.mass.compute_nnz());
    match &model.stiffness {
        Some(stiffness) => {
            let _ = write!(text, ", stiffness matrix with {} entries", stiffness.compute_nnz());
        }
        None => text.push_str(", no stiffness matrix"),
    }
    let _ = write!(
        text,
        "\nmass matrix differs between x, y and z by {:.1e} of its largest entry",
        model.mass_anisotropy
    );
    if !model.fixed_dofs.is_empty() {
        let _ = write!(
            text,
            "\n{} degrees of freedom are held by the export's boundary conditions",
            model.fixed_dofs.len()
        );
    }
    text
}

/// Rows of the nodes named by a node set, a node id, or node ids separated by commas.
pub fn node_rows(nodes: &Nodes, text: &str) -> Result<Vec<usize>> {
    if let Some(rows) = nodes.sets.get(text) {
        return Ok(rows.clone());
    }
    // Decks are not case-sensitive.
    if let Some((_, rows)) = nodes.sets.iter().find(|(name, _)| name.eq_ignore_ascii_case(text)) {
        return Ok(rows.clone());
    }
    let mut rows = Vec::new();
    for part in text.split(',') {
        let Ok(id) = part.trim().parse::<u64>() else {
            bail!("`{text}` is neither a node set ({}) nor a list of node ids", known_sets(nodes));
        };
        match nodes.row_of(id) {
            Some(row) => rows.push(row),
            None => bail!("there is no node {id}: expected {}", known_ids(nodes)),
        }
    }
    rows.sort_unstable();
    rows.dedup();
    Ok(rows)
}

fn known_sets(nodes: &Nodes) -> String {
    if nodes.sets.is_empty() {
        return "the files have none".to_owned();
    }
    let names: Vec<String> = nodes.sets.keys().map(|name| printable(name)).collect();
    format!("the files have {}", names.join(", "))
}

fn known_ids(nodes: &Nodes) -> String {
    match (nodes.ids.iter().min(), nodes.ids.iter().max()) {
        (Some(least), Some(greatest)) => format!("one of {} ids from {least} to {greatest}", nodes.ids.len()),
        _ => "nothing, the node table is empty".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use ffrf_fe::Nodes;

    use super::node_rows;

    #[test]
    fn nodes_are_named_by_set_or_id() {
        let nodes = Nodes {
            ids: vec![10, 20, 30],
            positions: vec![[0.0; 3]; 3],
            sets: BTreeMap::from([("Root".to_owned(), vec![0, 2])]),
        };
        assert_eq!(node_rows(&nodes, "ROOT").unwrap(), [0, 2]);
        assert_eq!(node_rows(&nodes, "20").unwrap(), [1]);
        assert_eq!(node_rows(&nodes, "30, 10,30").unwrap(), [0, 2]);
        let message = |text| node_rows(&nodes, text).unwrap_err().to_string();
        assert!(message("tip").contains("the files have Root"));
        assert!(message("7").contains("there is no node 7: expected one of 3 ids from 10 to 30"));
    }
}
