//! Meshes that gmsh wrote: frequencies against those of CalculiX on the same mesh, which tell the order of the nodes as well.

use std::path::Path;

use ffrf_fe::elements::Material;
use ffrf_fe::import::{ModelFiles, NodeSource, SolidsMaterial, read_model};
use ffrf_fe::modes::{ModeRequest, compute_modes};

/// CalculiX prints seven digits.
const PRINTED: f64 = 1e-6;
/// CalculiX integrates the mass of C3D10 with four points, which are too few to be exact; the difference grows with the frequency.
/// Two nodes in the place of each other turn elements inside out.
const FOUR_POINTS: f64 = 5e-4;

#[test]
fn clamped_beams_have_the_frequencies_of_calculix() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/gmsh");
    let table = std::fs::read_to_string(folder.join("frequencies.txt")).unwrap();
    for line in table.lines() {
        let tolerance = if line.starts_with("hex") { PRINTED } else { FOUR_POINTS };
        let mut words = line.split(' ');
        let nodes = NodeSource::Mesh {
            path: folder.join(words.next().unwrap()),
            materials: SolidsMaterial::all(Material::STEEL),
        };
        let model = read_model(&ModelFiles { nodes, mass: None, stiffness: None }).unwrap();
        let request = ModeRequest::clamped(4, model.nodes.sets["left end"].clone());
        let solution = compute_modes(&model, &request, &mut |_| {}).unwrap();
        for (expected, mode) in words.zip(&solution.report.modes) {
            let (expected, found): (f64, f64) = (expected.parse().unwrap(), mode.frequency_hz.unwrap());
            assert!((found / expected - 1.0).abs() < tolerance, "{line}: {found}");
        }
    }
}
