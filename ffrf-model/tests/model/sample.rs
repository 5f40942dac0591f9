//! A small body made of point masses, for the tests of this crate.
#![allow(dead_code)]

use ffrf_model::{
    Inertia, Marker, Mode, ModeKind, Provenance, ReducedBody, SCHEMA_VERSION, SourceFile, Vector3,
};
use ffrf_test_kit::random::Random;

/// A point mass with its position and mode rows.
pub struct Point {
    /// Mass.
    pub mass: f64,
    /// Position.
    pub position: Vector3,
    /// Displacement per mode.
    pub shapes: Vec<Vector3>,
}

/// Twelve points without any symmetry.
pub fn points(modes: usize) -> Vec<Point> {
    let mut numbers = Random::new(7);
    (0..12)
        .map(|_| Point {
            mass: 1.5 + numbers.number(),
            position: numbers.vector(),
            shapes: (0..modes).map(|_| numbers.vector()).collect(),
        })
        .collect()
}

/// The inertia invariants by their definition.
pub fn inertia(points: &[Point]) -> Inertia {
    let modes = points[0].shapes.len();
    let moment = |left: &dyn Fn(&Point) -> Vector3, right: &dyn Fn(&Point) -> Vector3| {
        let entry = |i: usize, j: usize| points.iter().map(|p| p.mass * left(p)[i] * right(p)[j]).sum();
        std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
    };
    let first = |field: &dyn Fn(&Point) -> Vector3| -> Vector3 {
        std::array::from_fn(|i| points.iter().map(|p| p.mass * field(p)[i]).sum())
    };
    Inertia {
        mass: points.iter().map(|p| p.mass).sum(),
        first_moment: first(&|p| p.position),
        modal_first_moment: (0..modes).map(|mu| first(&|p| p.shapes[mu])).collect(),
        second_moment: moment(&|p| p.position, &|p| p.position),
        position_mode_moment: (0..modes).map(|mu| moment(&|p| p.position, &|p| p.shapes[mu])).collect(),
        mode_mode_moment: (0..modes)
            .map(|mu| (0..modes).map(|nu| moment(&|p| p.shapes[mu], &|p| p.shapes[nu])).collect())
            .collect(),
    }
}

/// A body of `modes` modes with one marker.
pub fn body(modes: usize) -> ReducedBody {
    let points = points(modes);
    let square = |diagonal: f64, beside: f64| {
        (0..modes)
            .map(|i| (0..modes).map(|j| if i == j { diagonal * (1 + i) as f64 } else { beside }).collect())
            .collect()
    };
    ReducedBody {
        schema_version: SCHEMA_VERSION,
        title: "twelve [points], \"quoted\"".to_owned(),
        units: "m, kg, s".to_owned(),
        provenance: Provenance {
            tool: "ffrf".to_owned(),
            tool_version: "0.1.0".to_owned(),
            sources: vec![SourceFile {
                role: "nodes".to_owned(),
                file: "X.txt".to_owned(),
                sha256: "00".to_owned(),
            }],
            notes: Vec::new(),
        },
        modes: (0..modes).map(|_| Mode { kind: ModeKind::User, frequency_hz: Some(0.1) }).collect(),
        inertia: inertia(&points),
        stiffness: square(1e4, 17.0),
        damping: square(0.1, 0.0),
        geometric_stiffness: None,
        second_order_terms: Default::default(),
        stress_markers: Vec::new(),
        section_markers: Vec::new(),
        markers: vec![Marker {
            name: "tip".to_owned(),
            nodes: vec![11],
            position: points[11].position,
            translation: points[11].shapes.clone(),
            rotation: vec![[0.0; 3]; modes],
            coupling: None,
        }],
    }
}
