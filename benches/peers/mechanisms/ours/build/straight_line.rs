//! Accelerations, linearly implicit stages and projections of the mechanisms in straight-line code, from scenes of the same numbers.

use std::fmt::Write as _;
use std::path::Path;

use ffrf_codegen::{ArrayFunction, GenerateOptions, generate_array_function};
use ffrf_host::scene::Scene;
use ffrf_host::scene::file::SceneFile;
use ffrf_host::straight_line::{
    Motions, accelerations, implicit_accelerations, implicit_projection, projection,
};

use crate::LAYOUT_TOLERANCE;

/// Numbers of links of the rigid pendulums.
const LINKS: [usize; 7] = [1, 2, 4, 8, 16, 32, 64];

/// What a scene must say, but nobody asks for here.
const SIMULATION: &str = "[simulation]\nduration = 1.0\nstep = 1e-3\n";

/// The functions `pendulum_N` of the pendulums of `src/chains/pendulum.rs`.
pub fn pendulums() -> String {
    let code = LINKS.map(|links| {
        let file = SceneFile::parse(&pendulum(links)).expect("the text of a scene");
        let scene = Scene::compose(&file, Path::new("")).expect("a pendulum");
        let motions = Motions::of(&scene).expect("it moves");
        function(&accelerations(&scene, &motions, &format!("pendulum_{links}")).expect("accelerations exist"))
    });
    code.join("\n")
}

/// The functions `accelerations`, `implicit_accelerations` and, if it has joints, both projections of the mechanism of the scene of
/// a case beside the sources, whose body is in `folder`.
pub fn scene(case: &str, folder: &Path) -> String {
    let path = format!("scenes/{case}.toml");
    println!("cargo::rerun-if-changed={path}");
    let file = SceneFile::read(Path::new(&path)).expect("a scene");
    let scene = Scene::compose(&file, folder).expect("a mechanism").with_layout_tolerance(LAYOUT_TOLERANCE);
    let motions = Motions::of(&scene).expect("it moves");
    let mut functions = vec![
        accelerations(&scene, &motions, "accelerations").expect("accelerations exist"),
        implicit_accelerations(&scene, &motions, "implicit_accelerations")
            .expect("they exist in stages, too"),
    ];
    functions.extend(projection(&scene, &motions, "projection").expect("a projection exists"));
    functions.extend(
        implicit_projection(&scene, &motions, "implicit_projection").expect("it exists in stages, too"),
    );
    functions.iter().map(function).collect::<Vec<String>>().join("\n")
}

fn function(function: &ArrayFunction) -> String {
    generate_array_function(function, &GenerateOptions::default()).expect("valid code").text
}

/// The scene of so many links, stretched along x.
fn pendulum(links: usize) -> String {
    let mut text = format!("{SIMULATION}gravity = [0.0, -9.81, 0.0]\n");
    for link in 0..links {
        let before = if link == 0 { "ground".to_owned() } else { format!("link{}.TIP", link - 1) };
        let _ = write!(
            text,
            "[bodies.link{link}]\nmass = 0.6\ncenter_of_mass = [0.15, 0.0, 0.0]\n\
             inertia = [[1e-3, 0.0, 0.0], [0.0, 5e-3, 0.0], [0.0, 0.0, 5e-3]]\nmarkers.TIP = [0.3, 0.0, 0.0]\n\
             position = [{:?}, 0.0, 0.0]\n\
             [joints.hinge{link}]\nkind = \"revolute\"\nfirst = \"{before}\"\nsecond = \"link{link}\"\n",
            0.3 * link as f64
        );
    }
    text
}
