//! Small vibrations with known frequencies.

use ffrf_host::analysis::{Drives, eigenmodes, equilibrium, linearise};

use crate::{close, scene};

/// Eigenvalues of well-conditioned matrices of a few rows.
const ROUNDING: f64 = 1e-11;

const PENDULUM: &str = r#"
[simulation]
duration = 1.0
step = 1e-3
gravity = [0.0, -9.81, 0.0]
[bodies.bar]
mass = 2.0
center_of_mass = [0.5, 0.0, 0.0]
inertia = [[1e-3, 0.0, 0.0], [0.0, 0.2, 0.0], [0.0, 0.0, 0.2]]
orientation = [1.0, 0.0, 0.0, 0.3]
markers.TIP = [1.0, 0.0, 0.0]
[joints.pin]
kind = "revolute"
first = "ground"
second = "bar"
"#;

#[test]
fn a_pendulum_comes_to_rest_below_its_pin_and_swings_at_its_frequency() {
    let scene = scene(PENDULUM);
    let rest = equilibrium(&scene).unwrap();
    let down = rest.state[0].to_inertial(&nalgebra::Vector3::x());
    assert!((down - nalgebra::Vector3::new(0.0, -1.0, 0.0)).norm() < 1e-9, "{down}");
    let system = linearise(&scene, rest.time, &rest.state, Drives::Held).unwrap();
    assert_eq!(system.a.shape(), (2, 2));
    let modes = eigenmodes(&system.a).unwrap();
    let expected = (2.0 * 9.81 * 0.5 / (0.2_f64 + 2.0 * 0.25)).sqrt() / std::f64::consts::TAU;
    assert_eq!(modes.len(), 1);
    close("frequency", modes[0].frequency_hz(), expected, ROUNDING);
    assert!(modes[0].damping_ratio().abs() < ROUNDING);
}

#[test]
fn a_pendulum_that_begins_upside_down_comes_to_rest_below_as_well() {
    // 1e-3 rad beside the upper equilibrium
    let scene = scene(&PENDULUM.replace("[1.0, 0.0, 0.0, 0.3]", "[0.7075, 0.0, 0.0, 0.7067]"));
    let rest = equilibrium(&scene).unwrap();
    let down = rest.state[0].to_inertial(&nalgebra::Vector3::x());
    assert!((down.y + 1.0).abs() < 1e-9, "{down}");
}

/// Three masses in a row on springs, the first on the ground; every spring with a damper.
#[test]
fn a_chain_of_masses_has_the_frequencies_and_damping_of_a_chain() {
    let (mass, stiffness, damping) = (0.5_f64, 800.0_f64, 0.4_f64);
    let mut text = String::from("[simulation]\nduration = 1.0\nstep = 1e-3\n");
    for k in 1..=3 {
        let (before, place) = (if k == 1 { "ground".to_owned() } else { format!("m{}", k - 1) }, k as f64);
        text += &format!(
            "[bodies.m{k}]\nmass = {mass}\ninertia = [[1.0,0.0,0.0],[0.0,1.0,0.0],[0.0,0.0,1.0]]\nposition = [{place}, 0.0, 0.0]\n\
             [joints.g{k}]\nkind = \"prismatic\"\nfirst = \"ground\"\nsecond = \"m{k}\"\naxis = [1.0, 0.0, 0.0]\n\
             [forces.s{k}]\nkind = \"spring\"\nfirst = \"{before}\"\nsecond = \"m{k}\"\nstiffness = {stiffness}\ndamping = {damping}\n"
        );
    }
    let scene = scene(&text);
    let rest = equilibrium(&scene).unwrap();
    assert_eq!(rest.iterations, 0, "it begins at rest");
    let modes = eigenmodes(&linearise(&scene, rest.time, &rest.state, Drives::Held).unwrap().a).unwrap();
    assert_eq!(modes.len(), 3);
    for (k, mode) in modes.iter().enumerate() {
        // fixed-free chain: 2 √(k/m) sin((2j - 1) π / (2 (2n + 1)))
        let angle = (2 * k + 1) as f64 * std::f64::consts::PI / 14.0;
        let omega = 2.0 * (stiffness / mass).sqrt() * angle.sin();
        close("frequency", mode.frequency_hz(), omega / std::f64::consts::TAU, ROUNDING);
        // damping proportional to stiffness
        close("damping ratio", mode.damping_ratio(), 0.5 * damping / stiffness * omega, 1e-9);
    }
}

#[test]
fn a_rod_on_a_spring_hangs_where_weight_and_spring_balance() {
    let text = "[simulation]\nduration = 1.0\nstep = 1e-3\ngravity = [0.0, 0.0, -9.81]\n\
         [bodies.mass]\nmass = 3.0\ninertia = [[1.0,0.0,0.0],[0.0,1.0,0.0],[0.0,0.0,1.0]]\nposition = [0.0, 0.0, -1.0]\n\
         [joints.guide]\nkind = \"prismatic\"\nfirst = \"ground\"\nsecond = \"mass\"\n\
         [forces.spring]\nkind = \"spring\"\nfirst = \"ground\"\nsecond = \"mass\"\nstiffness = 500.0\nrest = 1.0\n";
    let rest = equilibrium(&scene(text)).unwrap();
    close("position", rest.state[0].position.z, -1.0 - 3.0 * 9.81 / 500.0, 1e-11);
}

#[test]
fn a_stiff_flexible_pendulum_comes_to_rest_below_its_pin() {
    let text = "[simulation]\nduration = 1.0\nstep = 1e-3\ngravity = [0.0, -9.81, 0.0]\n[bodies.rod]\nmodel = \"../conrod.ffrf.json\"\n\
         position = [0.04740099151709372, 0.0, 0.0]\n[joints.pin]\nkind = \"revolute\"\nfirst = \"ground\"\nsecond = \"rod.BIG_END\"\n";
    let rest = equilibrium(&scene(text)).unwrap();
    let down = rest.state[0].to_inertial(&nalgebra::Vector3::x());
    // the rod sags by less than a micrometre
    assert!((down.y + 1.0).abs() < 1e-6, "{down}");
    assert!(rest.state[0].modal_coordinates.0.norm() > 0.0);
    assert!(rest.iterations < 40, "{}", rest.iterations);
}

/// A second pendulum at the tip of one that is driven: rest is with the drive where it is, however it moves.
#[test]
fn a_driven_joint_is_held_where_it_is() {
    let text = format!(
        "{PENDULUM}drive = {{ angle = [0.4, 2.0, 3.0] }}\n\
         [bodies.lower]\nmass = 2.0\ncenter_of_mass = [0.5, 0.0, 0.0]\n\
         inertia = [[1e-3, 0.0, 0.0], [0.0, 0.2, 0.0], [0.0, 0.0, 0.2]]\nposition = [1.0, 0.0, 0.0]\n\
         [joints.elbow]\nkind = \"revolute\"\nfirst = \"bar.TIP\"\nsecond = \"lower\"\n"
    );
    let scene = scene(&text);
    let rest = equilibrium(&scene).unwrap();
    let direction = rest.state[0].to_inertial(&nalgebra::Vector3::x());
    close("angle", direction.y.atan2(direction.x), 0.4, 1e-12);
    let modes = eigenmodes(&linearise(&scene, 0.0, &rest.state, Drives::Held).unwrap().a).unwrap();
    assert_eq!(modes.len(), 1);
    let expected = (2.0 * 9.81 * 0.5 / (0.2_f64 + 2.0 * 0.25)).sqrt() / std::f64::consts::TAU;
    close("frequency", modes[0].frequency_hz(), expected, ROUNDING);
}
