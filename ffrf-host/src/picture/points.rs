//! Markers as pictures show them: names, places, and how modes move them.

use ffrf_model::ReducedBody;

use crate::scene::Scene;

/// A named point of a body. Frame: body.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedPoint {
    /// Its name.
    pub name: String,
    /// Reference position. Units: m.
    pub position: [f64; 3],
    /// Displacement per unit of each modal coordinate. Shape: M x 3.
    pub modes: Vec<[f64; 3]>,
    /// Ids of the nodes that an interface holds; empty for any other point.
    pub held: Vec<u64>,
}

/// The markers of every body of a scene that have a name.
pub fn named_points(scene: &Scene) -> Vec<Vec<NamedPoint>> {
    let bodies = scene.marker_names.iter().zip(scene.mechanism.markers());
    bodies
        .map(|(names, markers)| {
            let named = names.iter().zip(markers);
            named
                .map(|(name, marker)| {
                    let [x, y, z] = &marker.translation;
                    let rows = x.0.iter().zip(&y.0).zip(&z.0);
                    NamedPoint {
                        name: name.clone(),
                        position: marker.position.into(),
                        modes: rows.map(|((x, y), z)| [*x, *y, *z]).collect(),
                        held: Vec::new(),
                    }
                })
                .collect()
        })
        .collect()
}

/// The markers of a reduced body, and the places where its stress is observed.
pub fn model_points(body: &ReducedBody) -> Vec<NamedPoint> {
    let markers = body.markers.iter().map(|marker| NamedPoint {
        name: marker.name.clone(),
        position: marker.position,
        modes: marker.translation.clone(),
        held: if marker.coupling.is_some() { marker.nodes.clone() } else { Vec::new() },
    });
    // how modes move a stress marker is not in a model: it is drawn where it is at rest
    let stress = body.stress_markers.iter().map(|marker| NamedPoint {
        name: format!("{} (stress)", marker.name),
        position: marker.position,
        modes: vec![[0.0; 3]; body.modes.len()],
        held: Vec::new(),
    });
    markers.chain(stress).collect()
}
