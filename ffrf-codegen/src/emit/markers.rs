//! Names of the constants that stand for markers.

use std::collections::BTreeSet;

use ffrf_model::Marker;

/// The names of the markers in upper case, made unique and unlike the `reserved` ones.
pub(super) fn constant_names(markers: &[Marker], reserved: &[&str]) -> Vec<String> {
    let mut taken: BTreeSet<String> = reserved.iter().map(|&name| name.to_owned()).collect();
    markers
        .iter()
        .map(|marker| {
            let base: String = marker
                .name
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
        })
        .collect()
}
