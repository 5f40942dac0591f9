//! Evaluates the accelerations of a mechanism so and so often, for instruction counts: `count_mechanisms NAME CALLS`, or `count_mechanisms --list`.
#![forbid(unsafe_code)]

use std::hint::black_box;

use ffrf::mechanism::{Assembly, Constrained, Mechanism};
use ffrf::nalgebra::{UnitQuaternion, Vector3};
use ffrf::{StepError, StepReport, System};

ffrf::flexible_body! {
    /// The connecting rod with eight modes.
    pub struct Rod { model: "../../models/conrod.ffrf.json", modes: ..8 }
}

ffrf::flexible_body! {
    /// The same with four.
    pub struct Link { model: "../../models/conrod.ffrf.json", modes: ..4 }
}

ffrf::mechanism! {
    /// A crank, a flexible rod, a piston: one loop with redundant rows.
    pub struct SliderCrank {
        bodies: {
            crank: rigid {
                mass: 0.5,
                center_of_mass: [0.01, 0.0, 0.0],
                inertia: [2e-4, 4e-4, 5e-4],
                markers: { PIN: [0.04, 0.0, 0.0] },
            },
            rod: Rod,
            piston: rigid { mass: 0.3, inertia: [1e-4, 1e-4, 1e-4] },
        },
        gravity: [0.0, 0.0, -9.81],
        joints: {
            main: revolute(ground, crank, axis: z),
            big_end: revolute(crank.PIN, rod.BIG_END, axis: z),
            small_end: spherical(rod.SMALL_END, piston),
            guide: prismatic(ground, piston, axis: x),
        },
    }
}

/// A chain of so many links.
macro_rules! chain {
    ($name:ident $count:literal $joints:literal) => {
        ffrf::mechanism! {
            pub struct $name {
                bodies: { links: [Link; $count] },
                gravity: [0.0, -9.81, 0.0],
                joints: {
                    first: revolute(ground, links[0].BIG_END, axis: z),
                    hinges: for i in 0..$joints { revolute(links[i].SMALL_END, links[i + 1].BIG_END, axis: z) },
                },
            }
        }
    };
}
chain!(Chain2 2 1);
chain!(Chain8 8 7);
chain!(Chain64 64 63);

ffrf::mechanism! {
    /// One link.
    pub struct Chain1 {
        bodies: { link: Link },
        gravity: [0.0, -9.81, 0.0],
        joints: { first: revolute(ground, link.BIG_END, axis: z) },
    }
}

/// A pendulum of so many equal rigid links.
macro_rules! pendulum {
    ($name:ident $count:literal $joints:literal) => {
        ffrf::mechanism! {
            pub struct $name {
                bodies: {
                    links: [rigid {
                        mass: 0.5,
                        center_of_mass: [0.05, 0.0, 0.0],
                        inertia: [1e-4, 5e-4, 5e-4],
                        markers: { TIP: [0.1, 0.0, 0.0] },
                    }; $count],
                },
                gravity: [0.0, -9.81, 0.0],
                joints: {
                    first: revolute(ground, links[0], axis: z),
                    hinges: for i in 0..$joints { revolute(links[i].TIP, links[i + 1], axis: z) },
                },
            }
        }
    };
}
pendulum!(Pendulum8 8 7);
pendulum!(Pendulum64 64 63);

ffrf::mechanism! {
    /// Sixteen arms on a rigid hub.
    pub struct Star16 {
        bodies: { hub: rigid { mass: 1.0, inertia: [1e-2, 1e-2, 1e-2] }, arms: [Link; 16] },
        gravity: [0.0, -9.81, 0.0],
        joints: {
            center: revolute(ground, hub, axis: z),
            roots: for i in 0..16 { revolute(hub, arms[i].BIG_END, axis: z) },
        },
    }
}

/// So many arms on a flexible hub with eight modes.
macro_rules! flexible_star {
    ($name:ident $count:literal) => {
        ffrf::mechanism! {
            pub struct $name {
                bodies: { hub: Rod, arms: [Link; $count] },
                gravity: [0.0, -9.81, 0.0],
                joints: {
                    center: revolute(ground, hub.BIG_END, axis: z),
                    roots: for i in 0..$count { revolute(hub.SMALL_END, arms[i].BIG_END, axis: z) },
                },
            }
        }
    };
}
flexible_star!(FlexibleStar4 4);
flexible_star!(FlexibleStar16 16);
flexible_star!(FlexibleStar64 64);

ffrf::mechanism! {
    /// A binary tree of five levels.
    pub struct Tree31 {
        bodies: { nodes: [Link; 31] },
        gravity: [0.0, -9.81, 0.0],
        joints: {
            root: revolute(ground, nodes[0].BIG_END, axis: z),
            branches: for i in 1..31 {
                revolute(nodes[(i - 1) / 2].SMALL_END, nodes[i].BIG_END, axis: z)
            },
        },
    }
}

/// What `ffrf generate` prints for the scenes of this folder: the accelerations in straight-line code.
mod straight_line {
    pub mod pendulum_n8 {
        include!("../../../tests/golden/straight_pendulum_n8.rs");
    }
    pub mod slider_crank_m8 {
        include!("../../../tests/golden/straight_slider_crank_m8.rs");
    }
    pub mod supported_rod {
        include!("../../../tests/golden/straight_supported_rod.rs");
    }
}
use straight_line::supported_rod;

ffrf::mechanism! {
    /// The rod with four modes on two soft supports, as the scene `supported_rod` has it.
    pub struct SupportedRod {
        bodies: { rod: free Link },
        gravity: [0.0, 0.0, -9.81],
        forces: {
            left: bushing(ground.at([-0.04740099151709372, 0.0, 0.0]), rod.BIG_END, stiffness: [1e7, 2e7, 3e7, 0.0, 0.0, 0.0], damping: [1e2, 2e2, 3e2, 0.0, 0.0, 0.0]),
            right: bushing(ground.at([0.10225900184225423, 0.0, 0.0]), rod.SMALL_END, stiffness: [1e7, 2e7, 3e7, 0.0, 0.0, 0.0], damping: [1e2, 2e2, 3e2, 0.0, 0.0, 0.0]),
        },
    }
}

const NAMES: [&str; 18] = [
    "slider_crank_m8",
    "slider_crank_m8_straight_line",
    "slider_crank_m8_step_rk4",
    "slider_crank_m8_step_linearly_implicit",
    "supported_rod_m4_step_linearly_implicit",
    "supported_rod_m4_step_linearly_implicit_straight_line",
    "chain_m4_n1",
    "chain_m4_n2",
    "chain_m4_n8",
    "chain_m4_n64",
    "star_m4_n16",
    "flexible_star_m8_n4",
    "flexible_star_m8_n16",
    "flexible_star_m8_n64",
    "tree_m4_n31",
    "pendulum_rigid_n8",
    "pendulum_rigid_n8_straight_line",
    "pendulum_rigid_n64",
];

/// Accelerations of every body in the state at rest, joints open: the work does not depend on numbers.
#[inline(never)]
fn evaluate<A: Assembly<f64>>(mechanism: &Mechanism<A>, calls: usize) {
    let Mechanism { model, state, time } = mechanism;
    let zero = model.no_change(state);
    for _ in 0..calls {
        let rates = Constrained(model).rates(*time, black_box(state), &zero);
        assert!(black_box(rates).is_ok());
    }
}

macro_rules! rest {
    ($model:expr, $calls:expr) => {{
        let model = $model;
        evaluate(&model.in_motion(model.at_rest()), $calls);
    }};
}

/// The same with accelerations in straight-line code, which must hold in that state.
macro_rules! straight_line {
    ($model:expr, $calls:expr) => {{
        let model = $model;
        let mechanism = model.in_motion(model.at_rest());
        assert!(mechanism.straight_difference().is_some());
        evaluate(&mechanism, $calls);
    }};
}

/// Rate of the crank that drives a slider-crank. Units: rad/s.
const RATE: f64 = 150.0;
/// Step size. Units: s.
const STEP: f64 = 1e-4;

/// The slider-crank half a right angle from stretched, in motion; the joints are met.
fn turning() -> Mechanism<SliderCrank> {
    let model = SliderCrank::new(Rod);
    let mut state = model.at_rest();
    let crank = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 0.5);
    state.crank.orientation = crank;
    state.crank.angular_velocity.z = RATE;
    state.rod.position = crank * Vector3::new(0.04, 0.0, 0.0) + Vector3::new(0.047, 0.0, 0.0);
    state.piston.position.x = 0.18;
    let mut mechanism = model.in_motion(state);
    assert!(mechanism.assemble().is_ok());
    mechanism
}

/// Steps that follow each other.
#[inline(never)]
fn advance<A: Assembly<f64>>(
    mut mechanism: Mechanism<A>,
    calls: usize,
    step: impl Fn(&mut Mechanism<A>, f64) -> Result<StepReport, StepError>,
) {
    for _ in 0..calls {
        assert!(step(black_box(&mut mechanism), STEP).is_ok());
    }
}

fn call(name: &str, calls: usize) -> Option<()> {
    match name {
        "slider_crank_m8" => rest!(SliderCrank::new(Rod), calls),
        "slider_crank_m8_straight_line" => {
            straight_line!(straight_line::slider_crank_m8::SliderCrankM8::new(straight_line::slider_crank_m8::Rod), calls);
        }
        "slider_crank_m8_step_rk4" => {
            advance(turning(), calls, |mechanism, step| mechanism.step_rk4(0.01 * step))
        }
        "slider_crank_m8_step_linearly_implicit" => {
            advance(turning(), calls, Mechanism::step_linearly_implicit);
        }
        "supported_rod_m4_step_linearly_implicit" => {
            let model = SupportedRod::new(Link);
            advance(model.in_motion(model.at_rest()), calls, Mechanism::step_linearly_implicit);
        }
        "supported_rod_m4_step_linearly_implicit_straight_line" => {
            let model = supported_rod::SupportedRod::new(supported_rod::Rod);
            let mechanism = model.in_motion(model.at_rest());
            assert!(mechanism.straight_implicit_difference(STEP).is_some());
            advance(mechanism, calls, Mechanism::step_linearly_implicit);
        }
        "chain_m4_n1" => rest!(Chain1::new(Link), calls),
        "chain_m4_n2" => rest!(Chain2::new([Link; 2]), calls),
        "chain_m4_n8" => rest!(Chain8::new([Link; 8]), calls),
        "chain_m4_n64" => rest!(Chain64::new([Link; 64]), calls),
        "star_m4_n16" => rest!(Star16::new([Link; 16]), calls),
        "flexible_star_m8_n4" => rest!(FlexibleStar4::new(Rod, [Link; 4]), calls),
        "flexible_star_m8_n16" => rest!(FlexibleStar16::new(Rod, [Link; 16]), calls),
        "flexible_star_m8_n64" => rest!(FlexibleStar64::new(Rod, [Link; 64]), calls),
        "tree_m4_n31" => rest!(Tree31::new([Link; 31]), calls),
        "pendulum_rigid_n8" => rest!(Pendulum8::new(), calls),
        "pendulum_rigid_n64" => rest!(Pendulum64::new(), calls),
        "pendulum_rigid_n8_straight_line" => {
            straight_line!(straight_line::pendulum_n8::PendulumN8::new(), calls);
        }
        _ => return None,
    }
    Some(())
}

fn main() -> Result<(), String> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.as_slice() {
        [list] if list == "--list" => {
            NAMES.iter().for_each(|name| println!("{name}"));
            Ok(())
        }
        [name, calls] => {
            let calls = calls.parse().map_err(|_| format!("expected a number of calls, found `{calls}`"))?;
            call(name, calls).ok_or_else(|| format!("unknown mechanism `{name}`, see --list"))
        }
        _ => Err("usage: count_mechanisms NAME CALLS, or count_mechanisms --list".to_owned()),
    }
}
