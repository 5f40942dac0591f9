//! Mechanisms with redundant rows, in singular positions, and with joints that contradict each other.

use std::fmt::Write;

use ffrf_host::scene::Scene;
use ffrf_host::scene::file::SceneFile;

use crate::row;
use crate::settings::{Setting, largest};
use crate::table::{Figure, Real, Section, below, refused};
use crate::tolerances::{REDUNDANT, SINGULAR};

pub fn section() -> Section {
    Section {
        title: "Redundant and singular mechanisms",
        text: "Redundant: a door on several hinges of one axis moves as on one (distance, m or rad, after 1,000 RK4 steps of \
               1 ms under gravity across its axis). Singular: a four-bar linkage with two pairs of equal bars passes its \
               stretched position, where its rows lose rank: drift of energy over the largest kinetic energy; it may go on as \
               a parallelogram or crossed, which no equation decides. Contradictions are refused by name when a scene is assembled.",
        rows: vec![
            row!("door on 2 hinges against 1", door, 2),
            row!("door on 10 hinges against 1", door, 10),
            row!("four-bar linkage through its stretched position, RK4", linkage, false),
            row!("four-bar linkage, linearly implicit", linkage, true),
            row!("two hinges whose axes differ", crossed),
            row!("two points farther apart than the bar between them is long", too_far),
        ],
    }
}

const DOOR: &str = "[simulation]\nduration = 1.0\nstep = 1e-3\ngravity = [0.0, -9.81, 0.0]\n\
     [bodies.door]\nmass = 10.0\ninertia = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 2.0]]\nposition = [0.5, 0.0, 0.0]\n";

fn hinges(count: usize) -> String {
    let mut text = DOOR.to_owned();
    for k in 0..count {
        let height = k as f64 * 0.2;
        write!(
            text,
            "[joints.hinge{k}]\nkind = \"revolute\"\nfirst = \"ground\"\nfirst_position = [0.0, 0.0, {height}]\n\
             second = \"door\"\nsecond_position = [-0.5, 0.0, {height}]\n"
        )
        .unwrap();
    }
    text
}

fn door<T: Real>(count: usize) -> Figure {
    let (mut one, mut more) = (Setting::<T>::of(&hinges(1)), Setting::<T>::of(&hinges(count)));
    for _ in 0..1_000 {
        one.step(T::of(1e-3), false).unwrap();
        if let Err(error) = more.step(T::of(1e-3), false) {
            return refused(error);
        }
    }
    let apart = one.numbers().into_iter().zip(more.numbers()).map(|(a, b)| (a - b).abs());
    below::<T>(largest(apart), REDUNDANT)
}

/// Ground 1 m, coupler 1 m, cranks 0.5 m: begins upright, falls through the position in which all bars are on one line.
fn linkage<T: Real>(implicit: bool) -> Figure {
    let body = |name: &str, x: f64, y: f64| {
        format!(
            "[bodies.{name}]\nmass = 1.0\ninertia = [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]\nposition = [{x}, {y}, 0.0]\n"
        )
    };
    let pin = |name: &str, first: &str, [x, y]: [f64; 2], second: &str, [u, v]: [f64; 2]| {
        format!(
            "[joints.{name}]\nkind = \"revolute\"\nfirst = \"{first}\"\nfirst_position = [{x}, {y}, 0.0]\nsecond = \"{second}\"\n\
             second_position = [{u}, {v}, 0.0]\n"
        )
    };
    let mut text = "[simulation]\nduration = 1.0\nstep = 1e-3\ngravity = [1.0, -9.81, 0.0]\n".to_owned();
    text += &body("left", 0.0, 0.25);
    text += &body("coupler", 0.5, 0.5);
    text += &body("right", 1.0, 0.25);
    text += &pin("a", "ground", [0.0, 0.0], "left", [0.0, -0.25]);
    text += &pin("b", "left", [0.0, 0.25], "coupler", [-0.5, 0.0]);
    text += &pin("c", "coupler", [0.5, 0.0], "right", [0.0, 0.25]);
    text += &pin("d", "ground", [1.0, 0.0], "right", [0.0, -0.25]);
    let mut setting = Setting::<T>::of(&text);
    let first = setting.energy();
    let (mut drift, mut kinetic, mut lowest) = (0.0, 0.0_f64, 0.0_f64);
    for _ in 0..2_000 {
        let step = T::of(1e-3);
        let report = setting.step(step, implicit);
        if let Err(error) = report {
            return refused(error);
        }
        drift = largest([drift, (setting.energy() - first).abs()]);
        kinetic = kinetic.max(setting.kinetic_energy());
        lowest = lowest.min(setting.states[0].position.y.double());
    }
    assert!(lowest < -0.2, "it has passed the line: {lowest}");
    below::<T>(drift / kinetic, SINGULAR)
}

/// Why a scene has no initial state.
fn contradiction<T: Real>(joints: &str) -> Figure {
    let _ = T::SINGLE;
    let file = SceneFile::parse(&format!("{DOOR}{joints}")).unwrap();
    let scene = Scene::compose(&file, std::path::Path::new("")).unwrap();
    refused(scene.assembled().unwrap_err())
}

fn crossed<T: Real>() -> Figure {
    contradiction::<T>(
        "[joints.hinge]\nkind = \"revolute\"\nfirst = \"ground\"\nsecond = \"door\"\nsecond_position = [-0.5, 0.0, 0.0]\n\
         drive = { angle = [0.0, 1.0] }\n\
         [joints.other]\nkind = \"revolute\"\nfirst = \"ground\"\nsecond = \"door\"\nsecond_position = [-0.5, 0.0, 0.0]\n\
         axis = [1.0, 0.0, 0.0]\n",
    )
}

fn too_far<T: Real>() -> Figure {
    contradiction::<T>(
        "[joints.left]\nkind = \"spherical\"\nfirst = \"ground\"\nsecond = \"door\"\nsecond_position = [-0.5, 0.0, 0.0]\n\
         [joints.right]\nkind = \"spherical\"\nfirst = \"ground\"\nfirst_position = [3.0, 0.0, 0.0]\nsecond = \"door\"\n\
         second_position = [0.5, 0.0, 0.0]\n",
    )
}
