//! Inputs, outputs and the frequency response of one mass.

use ffrf_host::analysis::{Drives, equilibrium, frequency_response, linearise};
use nalgebra::Complex;

use crate::scene;

#[test]
fn a_mass_on_a_spring_answers_a_force_as_its_transfer_function_says() {
    let (m, k, d) = (2.0, 300.0, 5.0);
    let text = format!(
        "[simulation]\nduration = 1.0\nstep = 1e-3\n\
         [bodies.mass]\nmass = {m}\ninertia = [[1.0,0.0,0.0],[0.0,1.0,0.0],[0.0,0.0,1.0]]\nposition = [1.0, 0.0, 0.0]\n\
         [joints.guide]\nkind = \"prismatic\"\nfirst = \"ground\"\nsecond = \"mass\"\naxis = [1.0, 0.0, 0.0]\n\
         [forces.spring]\nkind = \"spring\"\nfirst = \"ground\"\nsecond = \"mass\"\nstiffness = {k}\ndamping = {d}\nrest = 1.0\n\
         [forces.push]\nkind = \"force\"\nsecond = \"mass\"\nvalue = [3.0, 0.0, 0.0]\n\
         [sensors.place]\nkind = \"position\"\nof = \"mass\"\n[sensors.speed]\nkind = \"velocity\"\nof = \"mass\"\n\
         [sensors.surge]\nkind = \"acceleration\"\nof = \"mass\"\n[sensors.guide]\nkind = \"reaction_moment\"\nof = \"guide\"\n"
    );
    let scene = scene(&text);
    let rest = equilibrium(&scene).unwrap();
    assert!((rest.state[0].position.x - (1.0 + 3.0 / k)).abs() < 1e-12);
    let system = linearise(&scene, rest.time, &rest.state, Drives::Held).unwrap();
    assert_eq!(system.inputs, ["push"]);
    assert_eq!(system.outputs[0], "place.x");
    assert_eq!(system.coordinates.len(), system.basis.nrows());
    let row = |name: &str| system.outputs.iter().position(|output| output == name).unwrap();
    for frequency in [0.0, 0.5, 1.9, 2.1, 40.0] {
        let response = &frequency_response(&system, &[frequency]).unwrap()[0];
        let s = Complex::new(0.0, std::f64::consts::TAU * frequency);
        let expected = Complex::new(1.0, 0.0) / (s * s * m + s * d + k);
        for (name, power) in [("place.x", 0), ("speed.x", 1), ("surge.x", 2)] {
            let expected = expected * s.powi(power);
            let found = response[(row(name), 0)];
            assert!(
                (found - expected).norm() < 1e-12 * (1.0 + expected.norm()),
                "{name}: {found} {expected}"
            );
        }
        assert!(response[(row("place.y"), 0)].norm() < 1e-15);
    }
}
