//! Standard input data to a reduced body.

use std::path::Path;

use ffrf_model::{
    Marker, Mode, ModeKind, ReducedBody, SecondOrderTerms, Units, Vector3, is_valid_marker_name,
};

use super::integrals::{Integrals, Matrices};
use super::taylor::{ModeIndex, Taylor, mode_index};
use super::text::{File, Node};
use crate::export::sid::IN_J;
use crate::import::formats::body::{Parts, body};
use crate::import::text::source::Source;
use crate::import::{INFLATED_LIMIT, ImportError};

/// Reads a body. Its markers are the nodes of the file.
///
/// What the file does not say of terms of second order in the modal coordinates is said by
/// [`ReducedBody::second_order_terms`]. Errors: a file that does not follow the format, matrices of another size, a modal force
/// of initial stresses, and a body that [`ReducedBody::check`] finds inconsistent.
pub fn read_sid(path: &Path, units: Option<Units>) -> Result<ReducedBody, ImportError> {
    let source = Source::read(path, INFLATED_LIMIT)?;
    let file = File::read(&source)?;
    let modes = file.modes.len();
    let every = file.matrices.iter().chain(file.nodes.iter().flat_map(|node| &node.matrices));
    let reader = Reader { source: &source, modes, index: mode_index(&source, every, modes)? };
    let find = |name: &str| file.matrices.iter().find(|matrix| matrix.name == name);
    let square = |name: &str| -> Result<Vec<Vec<f64>>, ImportError> {
        let Some(matrix) = find(name) else { return Ok(vec![vec![0.0; modes]; modes]) };
        if matrix.has_first() {
            let expected = format!("`{name}` that does not change with the modal coordinates");
            return Err(source.expected(matrix.at, expected));
        }
        let list = reader.zeroth(matrix, modes, modes)?;
        Ok(list.chunks(modes.max(1)).map(<[f64]>::to_vec).collect())
    };
    let mut stiffness = square("Ke")?;
    let damping = square("De")?;
    let mut notes = Vec::new();
    if !file.header.is_empty() {
        notes.push(format!("the file says: {}", ffrf_model::printable(&file.header)));
    }
    if let Some(initial) = find("ksigma") {
        reader.initial_stress(initial, &mut stiffness)?;
    }
    let matrices = reader.matrices(file.mass, &file.matrices, square("Me")?.concat())?;
    let Integrals { inertia, geometric_stiffness, second_order_terms, copies } = matrices.integrals();
    let copies: Vec<String> = copies.iter().map(|(names, by)| format!("{names} by {by:.1e}")).collect();
    if !copies.is_empty() {
        notes.push(format!("integrals that the file gives twice differ: {}", copies.join(", ")));
    }
    match second_order_terms {
        SecondOrderTerms::Together => notes.push(
            "Oe holds inertia and stress stiffness of second order in one, and Gr no term of first order that would \
             part them: a fidelity keeps both or neither"
                .to_owned(),
        ),
        SecondOrderTerms::Unknown => notes.push(
            "neither Oe nor Gr is given to first order: the body has no terms of second order, and fidelities up to linear"
                .to_owned(),
        ),
        _ => {}
    }
    if reader.index == ModeIndex::Third {
        notes.push("the third index of m1 counts the modes, not the second".to_owned());
    }
    let markers = file.nodes.iter().enumerate().map(|(k, node)| reader.marker(k, node, &mut notes));
    let markers = markers.collect::<Result<_, _>>()?;
    let parts = Parts {
        modes: file
            .modes
            .iter()
            .map(|name| Mode { kind: ModeKind::User, frequency_hz: frequency(name) })
            .collect(),
        inertia,
        stiffness,
        damping,
        geometric_stiffness,
        second_order_terms,
        markers,
        notes,
    };
    body(path, units, source.finish("standard input data"), parts)
}

/// The frequency in `Eigen Mode 7 : 51.626 Hz`.
fn frequency(name: &str) -> Option<f64> {
    let number = name.strip_suffix("Hz")?.trim_end();
    let number = number.rsplit([' ', ':']).next()?;
    number.parse().ok().filter(|frequency: &f64| frequency.is_finite() && *frequency >= 0.0)
}

struct Reader<'a> {
    source: &'a Source,
    modes: usize,
    index: ModeIndex,
}

impl Reader<'_> {
    /// M0 of this size.
    fn zeroth(&self, matrix: &Taylor, rows: usize, columns: usize) -> Result<Vec<f64>, ImportError> {
        matrix.expect_size(self.source, rows, columns)?;
        matrix.zeroth(self.source)
    }

    /// M1 of this size, if there is one.
    fn first(&self, matrix: &Taylor, rows: usize, columns: usize) -> Result<Option<Vec<f64>>, ImportError> {
        matrix.expect_size(self.source, rows, columns)?;
        Ok(matrix.has_first().then(|| matrix.first(self.modes, self.index)))
    }

    /// Stiffness of initial stresses goes to the stiffness; a force of theirs has no place in a body at rest.
    fn initial_stress(&self, matrix: &Taylor, stiffness: &mut [Vec<f64>]) -> Result<(), ImportError> {
        if let Some(entry) = matrix.zeroth.iter().find(|entry| entry.value != 0.0) {
            let expected = "ksigma of zero: modal forces of initial stresses are not supported";
            return Err(self.source.expected(entry.at, expected));
        }
        if let Some(first) = self.first(matrix, self.modes, 1)? {
            for (nu, column) in first.chunks(self.modes).enumerate() {
                for (row, entry) in stiffness.iter_mut().zip(column) {
                    row[nu] += entry;
                }
            }
        }
        Ok(())
    }

    fn matrices(&self, mass: f64, all: &[Taylor], me: Vec<f64>) -> Result<Matrices, ImportError> {
        let modes = self.modes;
        let find = |name: &str| all.iter().find(|matrix| matrix.name == name);
        let need = |name: &str| {
            let missing = || self.source.expected(self.source.bytes().len(), format!("the matrix `{name}`"));
            find(name).ok_or_else(missing)
        };
        need("Me")?;
        need("Ke")?;
        let (centre, tensor, ct, cr) = (need("mdCM")?, need("J")?, need("Ct")?, need("Cr")?);
        // 6 numbers, or a matrix of which the upper triangle is enough.
        let packed = (tensor.rows, tensor.columns) == (6, 1);
        let size = if packed { (6, 1) } else { (3, 3) };
        let six = |list: &[f64]| -> [f64; 6] {
            std::array::from_fn(|k| {
                let (i, j) = IN_J[k];
                if packed { list[k] } else { 0.5 * (list[3 * i + j] + list[3 * j + i]) }
            })
        };
        let zeroth = |name: &str, rows: usize, columns: usize| match find(name) {
            Some(matrix) => self.zeroth(matrix, rows, columns).map(Some),
            None => Ok(None),
        };
        let first = |name: &str, rows: usize, columns: usize| match find(name) {
            Some(matrix) => self.first(matrix, rows, columns),
            None => Ok(None),
        };
        let of_size = size.0 * size.1;
        Ok(Matrices {
            modes,
            mass,
            first_moment: self.zeroth(centre, 3, 1)?,
            modal_first_moment: self.first(centre, 3, 1)?,
            inertia: six(&self.zeroth(tensor, size.0, size.1)?),
            inertia_by_mode: self
                .first(tensor, size.0, size.1)?
                .map(|list| list.chunks(of_size).map(six).collect()),
            ct: self.zeroth(ct, modes, 3)?,
            ct_by_mode: self.first(ct, modes, 3)?,
            cr: self.zeroth(cr, modes, 3)?,
            cr_by_mode: self.first(cr, modes, 3)?,
            me,
            gr: zeroth("Gr", 3, 3 * modes)?,
            gr_by_mode: first("Gr", 3, 3 * modes)?,
            ge: zeroth("Ge", modes, 3 * modes)?,
            oe: zeroth("Oe", modes, 6)?,
            oe_by_mode: first("Oe", modes, 6)?,
        })
    }

    fn marker(&self, number: usize, node: &Node, notes: &mut Vec<String>) -> Result<Marker, ImportError> {
        let modes = self.modes;
        let find = |name: &str| node.matrices.iter().find(|matrix| matrix.name == name);
        let name = &node.name;
        let marker = if is_valid_marker_name(name) { name.clone() } else { format!("N{name}") };
        if !is_valid_marker_name(&marker) {
            let expected = "a node number, or a name of letters, digits and underscores";
            return Err(self.source.expected(node.at, expected));
        }
        let Some(origin) = find("origin") else {
            return Err(self.source.expected(node.at, "a node with an origin"));
        };
        let position = self.zeroth(origin, 3, 1)?;
        let shapes = |name: &str| -> Result<Vec<Vector3>, ImportError> {
            let Some(matrix) = find(name) else { return Ok(vec![[0.0; 3]; modes]) };
            let list = self.zeroth(matrix, 3, modes)?;
            Ok((0..modes).map(|mu| [0, 1, 2].map(|k| list[k * modes + mu])).collect())
        };
        if let Some(frame) = find("AP") {
            let turned = self.zeroth(frame, 3, 3)?;
            let is_unit = (0..9).all(|k| turned[k] == if k % 4 == 0 { 1.0 } else { 0.0 });
            if frame.structure != 0 && !is_unit {
                notes.push(format!("marker {marker}: axes of the body, not those of the node"));
            }
        }
        for name in ["phi", "psi"] {
            if find(name).is_some_and(Taylor::has_first) {
                notes.push(format!(
                    "marker {marker}: the stress stiffness of a force there ({name} M1) is left out"
                ));
            }
        }
        Ok(Marker {
            name: marker,
            nodes: vec![name.parse().unwrap_or(number as u64 + 1)],
            position: [position[0], position[1], position[2]],
            translation: shapes("phi")?,
            rotation: shapes("psi")?,
            coupling: None,
        })
    }
}
