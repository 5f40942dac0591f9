//! A frame of 1 kg with a mass on a spring in it: one mode, whose vibration is known in closed form.

use ffrf_codegen::fidelity::Fidelity;
use ffrf_codegen::{GenerateOptions, ScalarType, generate};
use ffrf_host::{HostBody, HostModal};
use ffrf_model::{Inertia, Mode, ModeKind, Provenance, ReducedBody, SCHEMA_VERSION};

use crate::table::Real;

/// Six points of the frame on its axes, their masses together 1 kg.
const ARM: f64 = 0.5;

/// A body whose fields are made by point masses: positions, masses, and for each mode the displacements.
pub fn of_points(
    positions: &[[f64; 3]],
    masses: &[f64],
    modes: &[Vec<[f64; 3]>],
    stiffness: Vec<Vec<f64>>,
) -> ReducedBody {
    let moment = |a: &[[f64; 3]], b: &[[f64; 3]]| {
        [0, 1, 2].map(|i| {
            [0, 1, 2].map(|j| masses.iter().zip(a.iter().zip(b)).map(|(m, (a, b))| m * a[i] * b[j]).sum())
        })
    };
    let first = |a: &[[f64; 3]]| [0, 1, 2].map(|i| masses.iter().zip(a).map(|(m, a)| m * a[i]).sum());
    let count = modes.len();
    ReducedBody {
        schema_version: SCHEMA_VERSION,
        title: "point masses".to_owned(),
        units: "m, kg, s, N".to_owned(),
        provenance: Provenance {
            tool: "ffrf".to_owned(),
            tool_version: "0.1.0".to_owned(),
            sources: Vec::new(),
            notes: Vec::new(),
        },
        modes: vec![Mode { kind: ModeKind::User, frequency_hz: None }; count],
        inertia: Inertia {
            mass: masses.iter().sum(),
            first_moment: first(positions),
            modal_first_moment: modes.iter().map(|mode| first(mode)).collect(),
            second_moment: moment(positions, positions),
            position_mode_moment: modes.iter().map(|mode| moment(positions, mode)).collect(),
            mode_mode_moment: modes.iter().map(|a| modes.iter().map(|b| moment(a, b)).collect()).collect(),
        },
        stiffness,
        damping: vec![vec![0.0; count]; count],
        geometric_stiffness: None,
        second_order_terms: Default::default(),
        markers: Vec::new(),
        stress_markers: Vec::new(),
        section_markers: Vec::new(),
    }
}

/// The frame with a mass (kg) in its centre that a spring (N/m) lets move along x.
pub fn two_masses(mass: f64, stiffness: f64) -> ReducedBody {
    let mut positions = vec![[0.0; 3]];
    for axis in 0..3 {
        for side in [-ARM, ARM] {
            let mut position = [0.0; 3];
            position[axis] = side;
            positions.push(position);
        }
    }
    let mut masses = vec![1.0 / 6.0; 7];
    masses[0] = mass;
    let mut mode = vec![[0.0; 3]; 7];
    mode[0] = [1.0, 0.0, 0.0];
    of_points(&positions, &masses, &[mode], vec![vec![stiffness]])
}

/// The kernels of a model in a number type, or why the generator refuses it.
pub fn kernels<T: Real>(body: &ReducedBody) -> Result<HostBody<T>, String> {
    let scalar = if T::SINGLE { ScalarType::F32 } else { ScalarType::F64 };
    let options = GenerateOptions { name: "Body".to_owned(), scalar, ..GenerateOptions::default() };
    generate(body, &options).map_err(|error| error.to_string())?;
    Ok(HostBody::new(body, &Fidelity::Full).cast())
}

/// Modal coordinates of these numbers.
pub fn modal<T: Real>(numbers: &[f64]) -> HostModal<T> {
    HostModal(ffrf::nalgebra::DVector::from_iterator(numbers.len(), numbers.iter().map(|x| T::of(*x))))
}
