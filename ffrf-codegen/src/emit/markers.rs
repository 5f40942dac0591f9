//! Names of the constants that stand for markers.

use std::collections::BTreeSet;

use ffrf_model::{MarkerLoadStiffness, ReducedBody};

use crate::fidelity::Fidelity;

/// The markers whose loads stress the body, with their numbers, as far as the fidelity keeps them.
pub(super) fn loads<'a>(body: &'a ReducedBody, fidelity: &Fidelity) -> Vec<(u16, &'a MarkerLoadStiffness)> {
    let loads = body.geometric_stiffness.iter().flat_map(|geometric| &geometric.marker_loads);
    let numbered = loads.filter_map(|load| {
        let number = body.markers.iter().position(|marker| marker.name == load.marker)?;
        Some((u16::try_from(number).ok()?, load))
    });
    if fidelity.keeps_load_stiffness() && body.mode_count() > 0 { numbered.collect() } else { Vec::new() }
}

/// The names of the markers in upper case, made unique and unlike the `reserved` ones: those of the markers, of the stress markers
/// and of the section markers.
pub(super) fn constant_names(body: &ReducedBody, reserved: &[&str]) -> [Vec<String>; 3] {
    let mut taken: BTreeSet<String> = reserved.iter().map(|&name| name.to_owned()).collect();
    let mut unique = |name: &str| {
        let base: String = name
            .chars()
            .map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_uppercase() } else { '_' })
            .collect();
        let base =
            if base.starts_with(|c: char| c.is_ascii_alphabetic()) { base } else { format!("M_{base}") };
        let mut name = base.clone();
        let mut copy = 2;
        while !taken.insert(name.clone()) {
            name = format!("{base}_MARKER{copy}");
            copy += 1;
        }
        name
    };
    let markers = body.markers.iter().map(|marker| unique(&marker.name)).collect();
    let stress = body.stress_markers.iter().map(|marker| unique(&marker.name)).collect();
    [markers, stress, body.section_markers.iter().map(|marker| unique(&marker.name)).collect()]
}
