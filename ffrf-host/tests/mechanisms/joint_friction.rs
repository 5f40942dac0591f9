//! Friction of scenes that follows the reaction of its joint.

use std::path::Path;

use ffrf_host::scene::Scene;
use ffrf_host::scene::file::SceneFile;
use ffrf_host::simulate::simulate;

/// Round-off of some hundred steps.
const EXACT: f64 = 1e-10;

fn compose(text: &str) -> Result<Scene, String> {
    let file = SceneFile::parse(text).map_err(|error| error.to_string())?;
    Scene::compose(&file, Path::new("")).map_err(|error| error.to_string())
}

/// A block on a slope of 0.4 rad under gravity; it has 3 m/s uphill.
fn block(simulation: &str, friction: &str) -> String {
    let (sine, cosine) = 0.4_f64.sin_cos();
    format!(
        r#"[simulation]
duration = 0.2
{simulation}
gravity = [{}, 0.0, {}]
output_step = 0.2
[bodies.body]
mass = 2.0
inertia = [[0.5, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 0.0, 0.5]]
velocity = [3.0, 0.0, 0.0]
[joints.rail]
kind = "prismatic"
first = "ground"
second = "body"
axis = [1.0, 0.0, 0.0]
[forces.rub]
kind = "friction"
joint = "rail"
{friction}
"#,
        -9.81 * sine,
        -9.81 * cosine
    )
}

#[test]
fn a_block_on_a_slope_slides_as_coulomb_says_with_every_integrator() {
    let (sine, cosine) = 0.4_f64.sin_cos();
    let expected = 3.0 - 9.81 * (sine + 0.3 * cosine) * 0.2;
    for simulation in [
        "step = 1e-3\nintegrator = \"symplectic_euler\"",
        "step = 1e-3\nconstraints = \"minimal\"",
        "step = 1e-3\nconstraints = \"baumgarte\"",
        "tolerance = 1e-10",
        "step = 1e-3\nintegrator = \"linearly_implicit\"",
        "step = 1e-3\nintegrator = \"linearly_implicit_euler\"",
        "step = 1e-3\nintegrator = \"generalized_alpha\"",
        "step = 1e-3\nintegrator = \"generalized_alpha\"\nconstraints = \"index3\"",
        "step = 1e-3\nintegrator = \"energy_momentum\"",
        "step = 1e-3\nintegrator = \"exponential\"",
    ] {
        let scene = compose(&block(simulation, "coefficient = 0.3\nspeed = 1e-7")).unwrap();
        let summary = simulate(&scene, None, |_| Ok(()), |_| ()).unwrap();
        let found = summary.end.bodies["body"].velocity[0];
        assert!((found - expected).abs() < EXACT, "{simulation}: {found} instead of {expected}");
    }
}

#[test]
fn keys_of_friction_that_follows_are_checked() {
    for (friction, expected) in [
        (
            "coefficient = -0.3\nspeed = 1.0",
            "forces.rub.coefficient: expected a number that is not negative, found -0.3",
        ),
        ("coefficient = 0.3", "forces.rub.speed: expected a number, found nothing"),
        ("coefficient = 0.3\nspeed = 1.0\nradius = 0.1", "forces.rub.radius: expected nothing"),
        (
            "coefficient = 0.3\nspeed = 1.0\nacts = \"about\"",
            "forces.rub.radius: expected the radius of the bearing",
        ),
        (
            "coefficient = 0.3\nspeed = 1.0\nacts = \"about\"\nradius = 0.0",
            "forces.rub.radius: expected a positive radius",
        ),
        ("limit = 0.3\nspeed = 1.0\nradius = 0.1", "forces.rub.radius: expected nothing"),
        ("speed = 1.0", "forces.rub.limit: expected a number, found nothing"),
    ] {
        let said = compose(&block("step = 1e-3", friction)).err().unwrap_or_default();
        assert!(said.contains(expected), "{friction}: {said}");
    }
    let alone = block("step = 1e-3", "coefficient = 0.3\nspeed = 1.0\nacts = \"along\"")
        .replace("joint = \"rail\"", "second = \"body\"");
    let said = compose(&alone).err().unwrap_or_default();
    assert!(said.contains("forces.rub.joint: expected the joint whose reaction it follows"), "{said}");
}
