//! Assembly of elements to a model, and a regular brick of hexahedra.

use faer::sparse::SymbolicSparseColMat;

use crate::{Element, ElementKind, FeModel, Nodes, SolidMaterial, SparseMatrix};

use super::shapes::HEXAHEDRON;
use super::{ElementError, ElementMatrices, Material, element_matrices};

/// No part has masses or stiffnesses like this; sums of many still are numbers.
const TOO_LARGE: f64 = 1e100;

/// Assembles isotropic elements of one material.
///
/// Errors: [`ElementError`] for a bad element.
/// Panics: never.
pub fn assemble(nodes: Nodes, elements: Vec<Element>, material: &Material) -> Result<FeModel, ElementError> {
    let all_of_it = vec![0; elements.len()];
    assemble_materials(nodes, elements, &[(String::new(), *material)], all_of_it)
}

/// Assembles isotropic elements of several materials: their names and constants, and which of them each element is made of.
///
/// Errors: [`ElementError`] for a bad element, or one without material.
/// Panics: never.
pub fn assemble_materials(
    nodes: Nodes,
    elements: Vec<Element>,
    materials: &[(String, Material)],
    element_materials: Vec<usize>,
) -> Result<FeModel, ElementError> {
    let count = nodes.len();
    let neighbours = neighbours(count, &elements)?;
    let mut mass = Columns::new(&neighbours, 1);
    let mut stiffness = Columns::new(&neighbours, 3);
    for (number, element) in elements.iter().enumerate() {
        let corners: Vec<[f64; 3]> = element.nodes.iter().map(|&row| nodes.positions[row]).collect();
        let material = element_materials.get(number).and_then(|&material| materials.get(material));
        let no_material = ElementError::NoMaterial { element: number, materials: materials.len() };
        let (_, material) = material.ok_or(no_material)?;
        let matrices = element_matrices(element.kind, &corners, material)
            .and_then(refuse_too_large)
            .map_err(|fault| ElementError::Numbered { element: number, fault: Box::new(fault) })?;
        for (b, &column) in element.nodes.iter().enumerate() {
            for (a, &row) in element.nodes.iter().enumerate() {
                let place = neighbours[column].partition_point(|&other| other < row);
                mass.add(column, 0, place, 0, matrices.mass[(a, b)]);
                for j in 0..3 {
                    for i in 0..3 {
                        stiffness.add(column, j, place, i, matrices.stiffness[(3 * a + i, 3 * b + j)]);
                    }
                }
            }
        }
    }
    Ok(FeModel {
        mass: mass.into_matrix(&neighbours),
        mass_anisotropy: 0.0,
        stiffness: Some(stiffness.into_matrix(&neighbours)),
        fixed_dofs: Vec::new(),
        elements,
        materials: materials
            .iter()
            .map(|(name, material)| SolidMaterial {
                name: name.clone(),
                elasticity: Some(material.elasticity()),
            })
            .collect(),
        element_materials,
        sources: Vec::new(),
        notes: Vec::new(),
        nodes,
    })
}

/// A rectangular brick of trilinear hexahedra with edges `lengths` (m), one corner at the origin.
///
/// Nodes are numbered along x first, then y, then z.
/// Errors: as [`assemble`], for lengths that are not positive.
pub fn brick(lengths: [f64; 3], divisions: [usize; 3], material: &Material) -> Result<FeModel, ElementError> {
    let counts = divisions.map(|division| division + 1);
    let row = |i: usize, j: usize, k: usize| (k * counts[1] + j) * counts[0] + i;
    let mut positions = Vec::with_capacity(counts.iter().product());
    for k in 0..counts[2] {
        for j in 0..counts[1] {
            for i in 0..counts[0] {
                let at = [i, j, k];
                positions
                    .push([0, 1, 2].map(|axis| lengths[axis] * at[axis] as f64 / divisions[axis] as f64));
            }
        }
    }
    let mut elements = Vec::with_capacity(divisions.iter().product());
    for k in 0..divisions[2] {
        for j in 0..divisions[1] {
            for i in 0..divisions[0] {
                let face =
                    |k: usize| [row(i, j, k), row(i + 1, j, k), row(i + 1, j + 1, k), row(i, j + 1, k)];
                elements
                    .push(Element { kind: ElementKind::Hexahedron8, nodes: [face(k), face(k + 1)].concat() });
            }
        }
    }
    let nodes = Nodes { ids: (1..=positions.len() as u64).collect(), positions, ..Nodes::default() };
    assemble(nodes, elements, material)
}

/// The same brick of 20-node hexahedra, which do not lock in bending.
///
/// Errors: as [`assemble`], for lengths that are not positive.
pub fn quadratic_brick(
    lengths: [f64; 3],
    divisions: [usize; 3],
    material: &Material,
) -> Result<FeModel, ElementError> {
    // Places on the grid of half edges: corners have even numbers only, middles of edges one that is odd.
    let counts = divisions.map(|division| 2 * division + 1);
    let place = |[i, j, k]: [usize; 3]| (k * counts[1] + j) * counts[0] + i;
    let mut row_of = vec![None; counts.iter().product()];
    let mut positions = Vec::new();
    for k in 0..counts[2] {
        for j in 0..counts[1] {
            for i in 0..counts[0] {
                let at = [i, j, k];
                if at.iter().filter(|&&number| number % 2 == 1).count() > 1 {
                    continue;
                }
                row_of[place(at)] = Some(positions.len());
                let length = |axis: usize| lengths[axis] * at[axis] as f64 / (2 * divisions[axis]) as f64;
                positions.push([length(0), length(1), length(2)]);
            }
        }
    }
    let mut elements = Vec::with_capacity(divisions.iter().product());
    for k in 0..divisions[2] {
        for j in 0..divisions[1] {
            for i in 0..divisions[0] {
                // Reference coordinates -1, 0, 1 are the half edges 0, 1, 2 of the element.
                let nodes = HEXAHEDRON.iter().filter_map(|corner| {
                    let half = corner.map(|x| (x + 1.0) as usize);
                    row_of[place([2 * i + half[0], 2 * j + half[1], 2 * k + half[2]])]
                });
                elements.push(Element { kind: ElementKind::Hexahedron20, nodes: nodes.collect() });
            }
        }
    }
    let nodes = Nodes { ids: (1..=positions.len() as u64).collect(), positions, ..Nodes::default() };
    assemble(nodes, elements, material)
}

fn refuse_too_large(matrices: ElementMatrices) -> Result<ElementMatrices, ElementError> {
    for matrix in [&matrices.mass, &matrices.stiffness] {
        let entries = (0..matrix.ncols()).flat_map(|column| matrix.col_as_slice(column));
        // a sum that overflowed is no number
        if let Some(&value) = entries.into_iter().find(|value| value.is_nan() || value.abs() >= TOO_LARGE) {
            return Err(ElementError::TooLarge { value, limit: TOO_LARGE });
        }
    }
    Ok(matrices)
}

/// Sorted neighbours of each node, itself included.
fn neighbours(count: usize, elements: &[Element]) -> Result<Vec<Vec<usize>>, ElementError> {
    let mut around: Vec<Vec<usize>> = vec![Vec::new(); count];
    for (number, element) in elements.iter().enumerate() {
        for &row in &element.nodes {
            let list = around.get_mut(row).ok_or(ElementError::UnknownNode {
                element: number,
                row,
                nodes: count,
            })?;
            list.push(number);
        }
    }
    let mut all = Vec::new();
    let lists = around.into_iter().map(|numbers| {
        all.clear();
        all.extend(numbers.iter().flat_map(|&number| &elements[number].nodes));
        all.sort_unstable();
        all.dedup();
        all.clone()
    });
    Ok(lists.collect())
}

/// Values of a matrix of small square blocks, column by column.
struct Columns {
    block: usize,
    /// Start of each node's columns, one more entry than nodes.
    starts: Vec<usize>,
    values: Vec<f64>,
}

impl Columns {
    fn new(neighbours: &[Vec<usize>], block: usize) -> Self {
        let mut starts = vec![0];
        for (node, list) in neighbours.iter().enumerate() {
            starts.push(starts[node] + list.len() * block * block);
        }
        let values = vec![0.0; starts[neighbours.len()]];
        Self { block, starts, values }
    }

    /// Adds to the entry of `column`'s direction `j` at its neighbour number `place`, direction `i`.
    fn add(&mut self, column: usize, j: usize, place: usize, i: usize, value: f64) {
        let height = (self.starts[column + 1] - self.starts[column]) / self.block;
        self.values[self.starts[column] + j * height + place * self.block + i] += value;
    }

    fn into_matrix(self, neighbours: &[Vec<usize>]) -> SparseMatrix {
        let size = neighbours.len() * self.block;
        let mut starts = Vec::with_capacity(size + 1);
        starts.push(0);
        let mut rows = Vec::with_capacity(self.values.len());
        for list in neighbours {
            for _ in 0..self.block {
                rows.extend(
                    list.iter().flat_map(|&node| (0..self.block).map(move |i| self.block * node + i)),
                );
                starts.push(rows.len());
            }
        }
        SparseMatrix::new(SymbolicSparseColMat::new_checked(size, size, starts, None, rows), self.values)
    }
}
