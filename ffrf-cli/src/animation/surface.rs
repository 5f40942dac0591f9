//! The surface of a part with the displacements of its modes, for pictures only.

use std::path::Path;

use anyhow::{Context, Result, bail};
use ffrf_host::picture::Shape;
use npyz::NpyFile;
use zip::ZipArchive;

use crate::results::{Array, archive};

/// A triangulated surface, and how modes move it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Surface(pub Shape);

impl Surface {
    /// The bytes of a file that [`read`](Self::read) reads: `points`, `triangles`, `shapes`, and `nodes`, the ids of the points.
    pub fn encode(&self) -> Result<Vec<u8>> {
        let Shape { points, triangles, modes, nodes } = &self.0;
        let flat = |points: &[[f64; 3]]| points.iter().flatten().copied().collect::<Vec<f64>>();
        let corners = triangles.iter().flatten().map(|point| f64::from(*point)).collect();
        let numbers = |shape: Vec<usize>, values: Vec<f64>| Array::Numbers { shape, values };
        archive([
            ("points".to_owned(), numbers(vec![points.len(), 3], flat(points))),
            ("triangles".to_owned(), numbers(vec![triangles.len(), 3], corners)),
            (
                "shapes".to_owned(),
                numbers(
                    vec![modes.len(), points.len(), 3],
                    modes.iter().flat_map(|shape| flat(shape)).collect(),
                ),
            ),
            ("nodes".to_owned(), numbers(vec![nodes.len()], nodes.iter().map(|id| *id as f64).collect())),
        ])
    }

    /// Reads a surface for a body of so many modes; the file may have more.
    ///
    /// Errors: it is no such file, has fewer modes, or triangles without points.
    pub fn read(path: &Path, mode_count: usize) -> Result<Self> {
        let shown = || format!("{}", path.display());
        let file = std::fs::File::open(path).with_context(shown)?;
        let mut archive = ZipArchive::new(file).with_context(shown)?;
        let nodes = match archive.by_name("nodes.npy") {
            Ok(entry) => NpyFile::new(entry).and_then(NpyFile::into_vec::<f64>).with_context(shown)?,
            // a file of an older version has none
            Err(_) => Vec::new(),
        };
        let mut array = |name: &str, axes: usize| -> Result<(Vec<usize>, Vec<f64>)> {
            let entry = archive.by_name(&format!("{name}.npy")).with_context(|| format!("array `{name}`"))?;
            let npy = NpyFile::new(entry).with_context(|| format!("array `{name}`"))?;
            let shape: Vec<usize> = npy.shape().iter().map(|length| *length as usize).collect();
            if shape.len() != axes || shape.last() != Some(&3) {
                bail!("array `{name}`: expected {axes} axes, the last of length 3, found {shape:?}");
            }
            let values = npy.into_vec::<f64>().with_context(|| format!("array `{name}`"))?;
            Ok((shape, values))
        };
        let read = (|| {
            let points = threes(&array("points", 2)?.1);
            let triangles = threes(&array("triangles", 2)?.1);
            let (shape, values) = array("shapes", 3)?;
            if shape[0] < mode_count || shape[1] != points.len() {
                bail!(
                    "array `shapes`: expected {mode_count} modes or more of {} points, found {} of {}",
                    points.len(),
                    shape[0],
                    shape[1]
                );
            }
            let known = |point: f64| point >= 0.0 && point.fract() == 0.0 && (point as usize) < points.len();
            if let Some(wrong) = triangles.iter().flatten().find(|point| !known(**point)) {
                bail!("array `triangles`: expected points from 0 to {}, found {wrong}", points.len() - 1);
            }
            let modes =
                threes(&values).chunks(points.len().max(1)).take(mode_count).map(<[_]>::to_vec).collect();
            let triangles =
                triangles.into_iter().map(|triangle| triangle.map(|point| point as u32)).collect();
            if !nodes.is_empty() && nodes.len() != points.len() {
                bail!("array `nodes`: expected {} ids or none, found {}", points.len(), nodes.len());
            }
            let nodes = nodes.iter().map(|id| *id as u64).collect();
            Ok(Self(Shape { points, triangles, modes, nodes }))
        })();
        read.with_context(shown)
    }
}

fn threes(values: &[f64]) -> Vec<[f64; 3]> {
    values.chunks_exact(3).map(|three| [three[0], three[1], three[2]]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_surface_comes_back_and_a_broken_one_is_refused() {
        let surface = Surface(Shape {
            points: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.5]],
            triangles: vec![[0, 1, 2]],
            modes: vec![vec![[0.1; 3]; 3], vec![[0.2; 3]; 3]],
            nodes: vec![7, 1, 300],
        });
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("s.npz");
        let store = |surface: &Surface| std::fs::write(&path, surface.encode().unwrap()).unwrap();
        store(&surface);
        assert_eq!(Surface::read(&path, 2).unwrap(), surface);
        assert_eq!(Surface::read(&path, 1).unwrap().0.modes.len(), 1);
        let said = |result: Result<Surface>| format!("{:#}", result.unwrap_err());
        assert!(said(Surface::read(&path, 3)).contains("expected 3 modes or more of 3 points, found 2 of 3"));
        store(&Surface(Shape { nodes: vec![1, 2], ..surface.0.clone() }));
        assert!(said(Surface::read(&path, 2)).contains("expected 3 ids or none, found 2"));
        store(&Surface(Shape { triangles: vec![[0, 1, 3]], ..surface.0 }));
        assert!(said(Surface::read(&path, 2)).contains("expected points from 0 to 2, found 3"));
        std::fs::write(&path, "no archive").unwrap();
        Surface::read(&path, 1).unwrap_err();
    }
}
