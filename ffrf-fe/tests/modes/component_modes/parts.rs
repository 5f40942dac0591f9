//! The parts that the tests reduce.

use ffrf_fe::FeModel;
use ffrf_fe::component_modes::{ComponentModes, ComponentRequest, Interface, NodeSelection, component_modes};
use ffrf_fe::elements::{Material, brick};

/// A steel bar of 240 x 40 x 30 mm, coarse enough for dense algebra.
pub fn bar() -> FeModel {
    brick([0.24, 0.04, 0.03], [6, 2, 2], &Material::STEEL).unwrap()
}

/// Rows of the nodes at a position along the bar.
pub fn section(model: &FeModel, x: f64) -> Vec<usize> {
    let plane = NodeSelection::Plane { point: [x, 0.0, 0.0], normal: [1.0, 0.0, 0.0], tolerance: 0.0 };
    plane.rows(&model.nodes).unwrap()
}

/// Both ends of the bar, coupled rigidly.
pub fn rigid_ends(model: &FeModel) -> Vec<Interface> {
    let end = |name, x| Interface::rigid(model, name, &section(model, x)).unwrap();
    vec![end("left", 0.0), end("right", 0.24)]
}

/// One end rigid, one by its mean, with reference points off the nodes.
pub fn mixed_ends(model: &FeModel) -> Vec<Interface> {
    let [left, right] = <[Interface; 2]>::try_from(rigid_ends(model)).unwrap();
    vec![left.averaged().at([-0.01, 0.02, 0.02]).unwrap(), right.at([0.26, 0.015, 0.01]).unwrap()]
}

pub fn compute(model: &FeModel, request: &ComponentRequest) -> ComponentModes {
    let modes = component_modes(model, request, &mut |_| {}).unwrap();
    println!("{}", modes.report);
    modes
}
