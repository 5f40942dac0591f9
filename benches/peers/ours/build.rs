//! Reads the body that `FFRF_BODY` names, as bodies.py wrote it, and generates its code.

use ffrf_codegen::{GenerateOptions, ScalarType, Strategy, generate};
use ffrf_model::{Inertia, Matrix3, Mode, ModeKind, Provenance, ReducedBody, SCHEMA_VERSION};

fn main() {
    println!("cargo::rerun-if-env-changed=FFRF_BODY");
    println!("cargo::rerun-if-env-changed=FFRF_STRATEGY");
    let path = std::env::var("FFRF_BODY").expect("FFRF_BODY names a file that bodies.py wrote");
    let bytes = std::fs::read(path).expect("FFRF_BODY can be read");
    let mut numbers =
        bytes.chunks_exact(8).map(|chunk| f64::from_le_bytes(chunk.try_into().expect("eight bytes")));
    let mut next = || numbers.next().expect("the file is complete");
    let (modes, _states) = (next() as usize, next());
    let body = read(modes, &mut next);
    let strategy = std::env::var("FFRF_STRATEGY").unwrap_or_else(|_| "auto".to_owned());
    let options = GenerateOptions {
        scalar: ScalarType::F64,
        strategy: Strategy::from_name(&strategy).expect("a known strategy"),
        // The modes are orthonormal up to the rounding of their numbers.
        layout_tolerance: 1e-12,
        ..GenerateOptions::default()
    };
    let code = generate(&body, &options).expect("a valid body").text;
    let folder = std::env::var("OUT_DIR").expect("cargo sets OUT_DIR");
    let head = format!(
        "/// Number of modes.\npub const M: usize = {modes};\n/// Number of velocities.\npub const N: usize = {};\n",
        6 + modes
    );
    std::fs::write(format!("{folder}/size.rs"), head).expect("OUT_DIR can be written to");
    std::fs::write(format!("{folder}/body.rs"), code).expect("OUT_DIR can be written to");
}

fn read(modes: usize, next: &mut impl FnMut() -> f64) -> ReducedBody {
    let mass = next();
    let first_moment = [mass * next(), mass * next(), mass * next()];
    let inertia = matrix(next);
    let half_trace = 0.5 * (inertia[0][0] + inertia[1][1] + inertia[2][2]);
    let second_moment =
        [0, 1, 2].map(|i| [0, 1, 2].map(|j| if i == j { half_trace } else { 0.0 } - inertia[i][j]));
    let inertia = Inertia {
        mass,
        first_moment,
        modal_first_moment: (0..modes).map(|_| [mass * next(), mass * next(), mass * next()]).collect(),
        second_moment,
        position_mode_moment: (0..modes).map(|_| matrix(next)).collect(),
        mode_mode_moment: (0..modes).map(|_| (0..modes).map(|_| matrix(next)).collect()).collect(),
    };
    let mut stiffness = vec![vec![0.0; modes]; modes];
    for (mu, row) in stiffness.iter_mut().enumerate() {
        row[mu] = next();
    }
    ReducedBody {
        schema_version: SCHEMA_VERSION,
        title: format!("random body of the benchmark with {modes} modes"),
        units: "none".to_owned(),
        provenance: Provenance {
            tool: "bodies.py".to_owned(),
            tool_version: "1".to_owned(),
            sources: Vec::new(),
            notes: Vec::new(),
        },
        modes: (0..modes).map(|_| Mode { kind: ModeKind::User, frequency_hz: None }).collect(),
        inertia,
        stiffness,
        damping: vec![vec![0.0; modes]; modes],
        geometric_stiffness: None,
        second_order_terms: Default::default(),
        stress_markers: Vec::new(),
        section_markers: Vec::new(),
        markers: Vec::new(),
    }
}

fn matrix(next: &mut impl FnMut() -> f64) -> Matrix3 {
    [(); 3].map(|()| [next(), next(), next()])
}
