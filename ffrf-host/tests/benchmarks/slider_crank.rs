//! The flexible slider-crank of Simeon: problem `crank` of the test set for IVP solvers.
//!
//! A planar rod with two lateral sine modes and two axial ones, a crank that is driven at 150 rad/s, no gravity. In space:
//! the rod gets a small moment of inertia about its own axis, which planar motion does not see.
//!
//! Source: B. Simeon, Modelling a flexible slider crank mechanism by a mixed system of DAEs and PDEs, Math. Modelling of
//! Systems 2 (1996) 1-18; numbers of crank.f, revision 2006-10-02.

use std::f64::consts::PI;
use std::path::Path;

use ffrf_model::{Inertia, Marker, Mode, ModeKind, Provenance, ReducedBody, SCHEMA_VERSION};

use super::run::{Run, near, run_text};

const ROD: f64 = 0.30;
const WIDTH: f64 = 0.008;
const DENSITY: f64 = 7870.0;
const YOUNG: f64 = 2e11;
const ROD_MASS: f64 = 0.151104;
const ROD_INERTIA: f64 = 0.0045339259;
/// About the rod's own axis: of no effect in the plane. Units: kg m².
const AXIAL_INERTIA: f64 = 1e-5;

/// The rod as crank.f has it: its axial masses are used as they stand there, fifteen times too large.
fn rod() -> ReducedBody {
    let area = WIDTH * WIDTH * ROD;
    let mass = DENSITY * area;
    let stiffness = YOUNG * WIDTH * WIDTH / ROD;
    let slender = (WIDTH / ROD).powi(2);
    let modal_mass = [
        [0.5 * mass, 0.0, 0.0, 0.0],
        [0.0, 0.5 * mass, 0.0, 0.0],
        [0.0, 0.0, 8.0 * mass, mass],
        [0.0, 0.0, mass, 2.0 * mass],
    ];
    let axial = |mu: usize| mu >= 2;
    // ρ B of crank.f, the rate of lateral against axial motion; the skew part of T_μν
    let mut turning = [[0.0; 4]; 4];
    for (mu, nu, value) in [(0, 2, -16.0 / PI.powi(3)), (0, 3, 8.0 / PI.powi(3) - 1.0 / PI), (1, 3, 0.5 / PI)]
    {
        turning[mu][nu] = mass * value;
    }
    let along = [0.0, 0.0, 2.0 / 3.0, 1.0 / 6.0].map(|c| mass * c);
    let across = [2.0 / PI, 0.0, 0.0, 0.0].map(|c| mass * c);
    let along_moment = [0.0, 0.0, 1.0 / 3.0, 1.0 / 6.0].map(|c| ROD * mass * c);
    let across_moment = [1.0 / PI, -0.5 / PI, 0.0, 0.0].map(|c| ROD * mass * c);
    let pair = |mu: usize, nu: usize| {
        let mut moment = [[0.0; 3]; 3];
        match (axial(mu), axial(nu)) {
            (true, true) => moment[0][0] = modal_mass[mu][nu],
            (false, false) => moment[1][1] = modal_mass[mu][nu],
            // ∫ρ φ_μˣ φ_νʸ
            (true, false) => moment[0][1] = -turning[nu][mu],
            (false, true) => moment[1][0] = -turning[mu][nu],
        }
        moment
    };
    let marker = |name: &str, x: f64, translation: [[f64; 3]; 4]| Marker {
        name: name.to_owned(),
        nodes: Vec::new(),
        position: [x, 0.0, 0.0],
        translation: translation.to_vec(),
        rotation: vec![[0.0; 3]; 4],
        coupling: None,
    };
    let still = [[0.0; 3]; 4];
    let mut tip = still;
    tip[3][0] = 1.0;
    ReducedBody {
        schema_version: SCHEMA_VERSION,
        title: "connecting rod of Simeon's slider-crank".to_owned(),
        units: "SI".to_owned(),
        provenance: Provenance {
            tool: "test".to_owned(),
            tool_version: "0".to_owned(),
            sources: Vec::new(),
            notes: Vec::new(),
        },
        modes: vec![Mode { kind: ModeKind::User, frequency_hz: None }; 4],
        inertia: Inertia {
            mass: ROD_MASS,
            first_moment: [0.5 * ROD_MASS * ROD, 0.0, 0.0],
            modal_first_moment: (0..4).map(|mu| [along[mu], across[mu], 0.0]).collect(),
            second_moment: [[ROD_INERTIA, 0.0, 0.0], [0.0; 3], [0.0, 0.0, AXIAL_INERTIA]],
            position_mode_moment: (0..4)
                .map(|mu| [[along_moment[mu], across_moment[mu], 0.0], [0.0; 3], [0.0; 3]])
                .collect(),
            mode_mode_moment: (0..4).map(|mu| (0..4).map(|nu| pair(mu, nu)).collect()).collect(),
        },
        stiffness: vec![
            vec![stiffness * PI.powi(4) / 24.0 * slender, 0.0, 0.0, 0.0],
            vec![0.0, stiffness * 2.0 * PI.powi(4) / 3.0 * slender, 0.0, 0.0],
            vec![0.0, 0.0, 16.0 / 3.0 * stiffness, -8.0 / 3.0 * stiffness],
            vec![0.0, 0.0, -8.0 / 3.0 * stiffness, 7.0 / 3.0 * stiffness],
        ],
        damping: vec![vec![0.0; 4]; 4],
        geometric_stiffness: None,
        second_order_terms: Default::default(),
        stress_markers: Vec::new(),
        section_markers: Vec::new(),
        markers: vec![marker("ROOT", 0.0, still), marker("TIP", ROD, tip)],
    }
}

fn scene(step: f64, output: f64) -> String {
    format!(
        r#"[simulation]
duration = 0.1
step = {step:?}
integrator = "rk4"
output_step = {output:?}

[bodies.crank]
mass = 0.36
center_of_mass = [0.0, 0.0, 0.0]
inertia = [[0.002727, 0.0, 0.0], [0.0, 0.002727, 0.0], [0.0, 0.0, 0.002727]]
angular_velocity = [0.0, 0.0, 150.0]
markers.PIN = [0.15, 0.0, 0.0]

[bodies.rod]
model = "rod.json"
position = [0.15, 0.0, 0.0]
velocity = [0.0, 22.5, 0.0]
angular_velocity = [0.0, 0.0, -74.99576703969453]
modal_coordinates = [0.0, 0.0, 1.03339863e-5, 1.69327969e-5]
modal_rates = [0.4448961125815990, 4.634339319238670e-3, -1.78591076e-6, -2.68938672e-6]

[bodies.slider]
mass = 0.075552
inertia = [[1e-4, 0.0, 0.0], [0.0, 1e-4, 0.0], [0.0, 0.0, 1e-4]]
position = [0.450016933, 0.0, 0.0]
velocity = [-2.68938672e-6, 0.0, 0.0]

[joints.main]
kind = "revolute"
first = "ground"
second = "crank"
drive = {{ angle = [0.0, 150.0] }}

[joints.big_end]
kind = "revolute"
first = "crank.PIN"
second = "rod.ROOT"

[joints.small_end]
kind = "spherical"
first = "rod.TIP"
second = "slider"

[joints.guide]
kind = "prismatic"
first = "ground"
second = "slider"
axis = [1.0, 0.0, 0.0]

[sensors.pin]
kind = "reaction_force"
of = "small_end"

[sensors.shaft]
kind = "reaction_moment"
of = "main"
"#
    )
}

fn run(step: f64, folder: &Path) -> Run {
    std::fs::write(folder.join("rod.json"), serde_json::to_string(&rod()).unwrap()).unwrap();
    run_text(&scene(step, 0.1), folder)
}

/// At 0.1 s: φ₂, x₃ and their rates; q and its rates. Source: `solut()` of crank.f.
const ROD_ANGLE: f64 = -0.331_173_498_825_626;
const SLIDER: f64 = 0.169_737_332_842_786;
const ROD_RATE: f64 = 60.25346755138369;
const SLIDER_RATE: f64 = -8.753116326670527;
const AMPLITUDES: [f64; 4] =
    [1.893192899613509e-4, 2.375751249879174e-5, -5.323896770569702e-6, -8.363313279112129e-6];
const RATES: [f64; 4] =
    [-3.005541400289738e-2, -5.500431812571696e-3, 4.974111734266989e-4, 1.105560003626645e-3];
/// Multipliers of the two loop equations, y then x, and of the driven angle.
const MULTIPLIERS: [f64; 3] = [-62.32935833287916, -163.7920993367306, 25.29857947066878];

/// crank.f takes 3.1415927 for π and its numbers hold the joints to 2e-10: eight digits of positions are left.
const POSITION: f64 = 2e-9;
/// The same residual, in the axial modes: four digits of each amplitude.
const AMPLITUDE: f64 = 8e-5;
/// It lets the axial modes ring, by 6e-10 m with 2e4 rad/s: that much of every rate at the small end. Units: m/s.
const RINGING: f64 = 2e-5;
/// And of the reactions, (2e4 rad/s)² times 6e-10 m times the 0.15 kg of slider and half the rod. Units: N.
const RINGING_FORCE: f64 = 0.04;

#[test]
fn simeons_slider_crank_ends_where_the_test_set_says() {
    let folder = tempfile::tempdir().unwrap();
    let run = run(1.25e-5, folder.path());
    let angle = 2.0 * run.last("rod.orientation.z").atan2(run.last("rod.orientation.w"));
    // half the angle is known but for half turns
    let angle = angle - 2.0 * PI * (angle / (2.0 * PI)).round();
    near("rod angle", angle, ROD_ANGLE, POSITION);
    near("slider", run.last("slider.position.x"), SLIDER, POSITION);
    near("rod rate", run.last("rod.angular_velocity.z"), ROD_RATE, RINGING / ROD * 2.0);
    near("slider rate", run.last("slider.velocity.x"), SLIDER_RATE, RINGING);
    for (mode, (amplitude, rate)) in AMPLITUDES.iter().zip(RATES).enumerate() {
        let column = |kind: &str| format!("rod.{kind}.{}", mode + 1);
        let name = column("modal_coordinates");
        near(&name, run.last(&name), *amplitude, AMPLITUDE * amplitude.abs());
        near(&column("modal_rates"), run.last(&column("modal_rates")), rate, RINGING);
    }
    // on the slider, and on the crank: the test set counts its multipliers with the signs of its constraints
    let (pin, shaft) = (run.last_vector("pin"), run.last("shaft.z"));
    near("pin y", pin.y, MULTIPLIERS[0], RINGING_FORCE);
    near("pin x", pin.x, -MULTIPLIERS[1], RINGING_FORCE);
    near("shaft", shaft, -MULTIPLIERS[2], RINGING_FORCE * 0.15);
    let [position, velocity] = run.drift();
    assert!(position < 1e-13 && velocity < 1e-10, "{position:e}, {velocity:e}");
}
