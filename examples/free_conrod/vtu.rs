//! The deforming rod for ParaView: one `.vtu` file per frame and a `.pvd` file that lists them with their times.

use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::path::Path;

use ffrf::nalgebra::Vector3;
use ffrf_fe::ElementKind;
use vtkio::model::{
    Attribute, Attributes, ByteOrder, CellType, Cells, DataSet, UnstructuredGridPiece, Version,
    VertexNumbers, Vtk,
};

use crate::flight::Sample;
use crate::part::Part;

/// Largest drawn displacement over the size of the part.
const VISIBLE: f64 = 0.06;

/// Writes `conrod.pvd` and the frames beside it.
pub fn write_series(folder: &Path, frames: &[Sample], part: &Part) -> Result<(), Box<dyn Error>> {
    let exaggeration = exaggeration(frames, part);
    let cells = cells(part)?;
    let mut collection = String::from(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n",
    );
    for (number, frame) in frames.iter().enumerate() {
        let name = format!("conrod_{number:04}.vtu");
        vtu(frame, part, exaggeration, cells.clone()).export(folder.join(&name))?;
        writeln!(
            collection,
            "<DataSet timestep=\"{:.6}\" group=\"\" part=\"0\" file=\"{name}\"/>",
            frame.time
        )?;
    }
    collection.push_str("</Collection>\n</VTKFile>\n");
    let path = folder.join("conrod.pvd");
    fs::write(&path, collection)?;
    println!(
        "  written: {} ({} frames; displacements drawn {exaggeration} times too large, true ones in the field `displacement`)",
        path.display(),
        frames.len()
    );
    Ok(())
}

/// A round factor that makes the largest displacement visible.
fn exaggeration(frames: &[Sample], part: &Part) -> f64 {
    let size = |i: usize| {
        let coordinates = part.model.nodes.positions.iter().map(|position| position[i]);
        let (low, high) = coordinates.fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x), high.max(x)));
        high - low
    };
    let largest = frames
        .iter()
        .map(|frame| part.largest_displacement(frame.state.modal_coordinates.as_slice()))
        .fold(f64::MIN_POSITIVE, f64::max);
    let factor = VISIBLE * (0..3).map(size).fold(0.0, f64::max) / largest;
    let decade = 10_f64.powf(factor.log10().floor());
    [5.0, 2.0, 1.0].into_iter().map(|step| step * decade).find(|&step| step <= factor).unwrap_or(decade)
}

fn cells(part: &Part) -> Result<Cells, Box<dyn Error>> {
    let (mut connectivity, mut offsets, mut types) = (Vec::new(), Vec::new(), Vec::new());
    for element in &part.model.elements {
        types.push(match element.kind {
            // VTK and CalculiX number these alike
            ElementKind::Tetrahedron4 => CellType::Tetra,
            ElementKind::Tetrahedron10 => CellType::QuadraticTetra,
            ElementKind::Hexahedron8 => CellType::Hexahedron,
            ElementKind::Hexahedron20 => CellType::QuadraticHexahedron,
            ElementKind::Wedge6 => CellType::Wedge,
            other => return Err(format!("no VTK cell for {other:?}").into()),
        });
        connectivity.extend(element.nodes.iter().map(|&node| node as u64));
        offsets.push(connectivity.len() as u64);
    }
    Ok(Cells { cell_verts: VertexNumbers::XML { connectivity, offsets }, types })
}

/// One frame: nodes at p + A (x + exaggeration Ψ q), true displacements A Ψ q as a field.
fn vtu(frame: &Sample, part: &Part, exaggeration: f64, cells: Cells) -> Vtk {
    let state = &frame.state;
    let (mut points, mut displacements) = (Vec::<f32>::new(), Vec::<f32>::new());
    for (n, position) in part.model.nodes.positions.iter().enumerate() {
        let bent = Vector3::from(part.displacement(n, state.modal_coordinates.as_slice()));
        let drawn = state.position + state.to_inertial(&(Vector3::from(*position) + exaggeration * bent));
        points.extend(drawn.iter().map(|&x| x as f32));
        displacements.extend(state.to_inertial(&bent).iter().map(|&x| x as f32));
    }
    let displacement = Attribute::vectors("displacement").with_data(displacements);
    Vtk {
        version: Version::new_xml(1, 0),
        title: String::new(),
        byte_order: ByteOrder::LittleEndian,
        data: DataSet::inline(UnstructuredGridPiece {
            points: points.into(),
            cells,
            data: Attributes { point: vec![displacement], cell: Vec::new() },
        }),
        file_path: None,
    }
}
