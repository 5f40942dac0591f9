//! Random mechanisms: which bodies are joined, by what, in which state.

use ffrf_host::mechanism::{Drive, HostPorts};
use ffrf_host::{HostBody, HostMechanism, HostModal};
use ffrf_model::ReducedBody;
use ffrf_runtime::joints::JointKind;
use ffrf_runtime::mechanism::{Attachment, Connection, Port};
use ffrf_runtime::{Marker, State, Wrench, rotation};
use ffrf_test_kit::every_joint::every_kind;
use ffrf_test_kit::random::Random;
use nalgebra::{UnitQuaternion, Vector3};

use super::bodies::{MARKERS, body, model, state};
use super::witness::{Naive, naive};

/// How the joints connect the bodies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// From the ground, one after the other.
    Chain,
    /// The same without ground.
    FreeChain,
    /// Each body on a random one before it.
    Tree,
    /// All bodies on the first, which is on the ground.
    Star,
    /// A free ring.
    Ring,
    /// A chain with both ends on the ground.
    Bridge,
    /// A tree with two more joints between random bodies.
    Loops,
}

pub const SHAPES: [Shape; 7] =
    [Shape::Chain, Shape::FreeChain, Shape::Tree, Shape::Star, Shape::Ring, Shape::Bridge, Shape::Loops];

/// Two bodies, or a body and the ground; and whether this joint closes a loop.
type Edge = ([Option<usize>; 2], bool);

fn edges(shape: Shape, count: usize, random: &mut Random) -> Vec<Edge> {
    let mut below = |k: usize| (((random.number() + 1.0) / 2.0 * k as f64) as usize).min(k - 1);
    let mut edges: Vec<Edge> = (0..count)
        .filter_map(|k| match shape {
            Shape::FreeChain | Shape::Ring if k == 0 => None,
            _ if k == 0 => Some(([None, Some(0)], false)),
            Shape::Star => Some(([Some(0), Some(k)], false)),
            Shape::Tree | Shape::Loops => Some(([Some(below(k)), Some(k)], false)),
            _ => Some(([Some(k - 1), Some(k)], false)),
        })
        .collect();
    match shape {
        Shape::Ring => edges.push(([Some(count - 1), Some(0)], true)),
        Shape::Bridge => edges.push(([Some(count - 1), None], true)),
        Shape::Loops => {
            for _ in 0..2 {
                let first = below(count);
                edges.push(([Some(first), Some((first + 1 + below(count - 1)) % count)], true));
            }
        }
        _ => {}
    }
    edges
}

/// A mechanism in a state, with the witnesses of its bodies.
pub struct Case {
    pub name: String,
    pub mechanism: HostMechanism,
    pub witnesses: Vec<Box<dyn Naive>>,
    pub states: Vec<State<HostModal>>,
    /// What acts at the first marker of each body, besides gravity.
    pub wrenches: Vec<Wrench>,
}

/// Gravity of every case. Units: m/s².
pub const GRAVITY: Vector3<f64> = Vector3::new(1.0, -2.0, -9.0);

/// A random mechanism of `count` bodies with up to five modes each, in a random state that meets no joint.
pub fn random_case(shape: Shape, count: usize, seed: u64) -> Case {
    let modes: Vec<usize> = (0..count).map(|k| (seed as usize + 3 * k) % 6).collect();
    random_case_of(shape, &modes, seed)
}

/// A random mechanism of bodies with these numbers of modes, in a random state that meets no joint.
pub fn random_case_of(shape: Shape, modes: &[usize], seed: u64) -> Case {
    let count = modes.len();
    let mut random = Random::new(seed);
    let kinds = every_kind::<f64>();
    let plain: Vec<_> = kinds.iter().filter(|kind| !matches!(kind, JointKind::Generic(_))).copied().collect();
    let edges = edges(shape, count, &mut random);
    let joints = edges
        .iter()
        .map(|(ends, closes)| {
            let kind = loop {
                // the generic joint has 63 choices: one draw in four is any of all
                let list = if random.number() > 0.5 { &kinds } else { &plain };
                let kind = list[((random.number() + 1.0) / 2.0 * list.len() as f64) as usize % list.len()];
                // what closes a loop leaves it room to move
                if !closes || kind.row_count() <= 2 {
                    break kind;
                }
            };
            let (first, second) = (attachment(ends[0], &mut random), attachment(ends[1], &mut random));
            (Connection { kind, first, second }, None)
        })
        .collect();
    let name = format!("{shape:?} of {count}, modes {modes:?}, seed {seed}");
    case(name, modes, joints, seed, &mut random)
}

/// A random triad on a body, or on the ground.
pub fn attachment(body: Option<usize>, random: &mut Random) -> Attachment<f64> {
    Attachment {
        body,
        marker: if random.number() > 0.0 { 0 } else { 1 + usize::from(random.number() > 0.0) } % MARKERS,
        position: random.vector().into(),
        orientation: turn(random),
    }
}

/// Any orientation.
pub fn turn(random: &mut Random) -> UnitQuaternion<f64> {
    let [i, j, k] = random.vector();
    rotation::from_euler_parameters([random.number() + 0.01, i, j, k]).unwrap()
}

/// Bodies with these numbers of modes and joints between them, loads included, in a random state.
pub fn case(name: String, modes: &[usize], joints: Joints, seed: u64, random: &mut Random) -> Case {
    let models: Vec<_> = modes.iter().enumerate().map(|(k, modes)| model(seed + k as u64, *modes)).collect();
    let bodies = models.iter().map(|model| body(model, random)).collect();
    let states = modes.iter().map(|modes| state(*modes, random)).collect();
    loaded(name, &models, bodies, joints, states, random)
}

/// Rigid bodies at rest with the frame of the ground, each with markers (from number 2 on) at two points of the ground.
pub fn rigid_case(name: &str, points: &[[Vector3<f64>; 2]], joints: Joints, random: &mut Random) -> Case {
    let models: Vec<_> = (0..points.len()).map(|k| model(1 + k as u64, 0)).collect();
    let bodies = models.iter().zip(points).map(|(model, points)| {
        let (body, mut markers) = body(model, random);
        markers.truncate(2);
        markers.extend(points.iter().map(|point| Marker::rigid(*point, &HostModal::zeros(0))));
        (body, markers)
    });
    let bodies: Vec<_> = bodies.collect();
    let states = bodies.iter().map(|(body, _)| State::at_rest(body)).collect();
    loaded(name.to_owned(), &models, bodies, joints, states, random)
}

/// Joints with their drives.
pub type Joints = Vec<(Connection<f64>, Option<Drive>)>;

fn loaded(
    name: String,
    models: &[ReducedBody],
    bodies: Vec<(HostBody, Vec<Marker<HostModal, f64>>)>,
    joints: Joints,
    states: Vec<State<HostModal>>,
    random: &mut Random,
) -> Case {
    let wrenches: Vec<Wrench> = models
        .iter()
        .map(|_| Wrench { force: Vector3::from(random.vector()) * 10.0, moment: random.vector().into() })
        .collect();
    let loads = wrenches.clone();
    let push = move |_: f64, ports: &mut HostPorts<'_>| {
        for (port, wrench) in ports.0.iter_mut().zip(&loads) {
            port.push(0, wrench);
        }
    };
    let mechanism = HostMechanism::new(bodies, joints, GRAVITY).unwrap().with_forces(Box::new(push));
    Case { name, mechanism, witnesses: models.iter().map(naive).collect(), states, wrenches }
}
