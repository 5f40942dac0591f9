//! Mechanisms in other number types.

use ffrf::mechanism;
use ffrf::nalgebra::RealField;
use num_dual::Dual64;

use crate::bodies::GenericRod;

mechanism! {
    /// A pendulum with a crank in any number type.
    pub struct Swing {
        bodies: {
            arm: rigid { mass: 0.2, center_of_mass: [0.05, 0.0, 0.0], inertia: [1e-5, 1e-4, 1e-4] },
            rod: GenericRod,
        },
        gravity: [0.0, -9.81, 0.0],
        joints: {
            pin: revolute(ground, arm, axis: z),
            hinge: revolute(arm.at([0.1, 0.0, 0.0]), rod.BIG_END, axis: z),
        },
        forces: { coil: torsion_spring(hinge, stiffness: 2.0, damping: 0.01) },
        sensors: { tip: position(rod.SMALL_END) },
        scalar: generic,
    }
}

/// The height of the tip after some steps, with this stiffness of the spring.
fn height<T: RealField + Copy>(stiffness: T, step: f64, tolerance: f64) -> T {
    let mut model = Swing::<T>::new(GenericRod);
    model.coil.kind.stiffness = stiffness;
    let mut swing = model.in_motion(model.at_rest());
    swing.assemble().unwrap();
    for _ in 0..40 {
        let report = swing.step_linearly_implicit(ffrf::nalgebra::convert(step)).unwrap();
        assert!(report.drift.position < ffrf::nalgebra::convert(tolerance));
    }
    model.tip(&swing.state).y
}

#[test]
fn single_precision_agrees_with_double() {
    let double = height(2.0_f64, 5e-4, 1e-6);
    let single = height(2.0_f32, 5e-4, 1e-4);
    assert!((f64::from(single) - double).abs() < 1e-5, "{single} {double}");
}

#[test]
fn a_whole_simulation_is_differentiated() {
    let derivative = height(Dual64::from(2.0).derivative(), 5e-4, 1e-6).eps;
    let step = 1e-4;
    let difference = (height(2.0 + step, 5e-4, 1e-6) - height(2.0 - step, 5e-4, 1e-6)) / (2.0 * step);
    assert!((derivative - difference).abs() < 1e-5 * difference.abs(), "{derivative} {difference}");
    assert!(derivative.abs() > 1e-9);
}
