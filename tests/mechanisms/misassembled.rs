//! States that no joint can be met in are refused with the joint's name.

use ffrf::mechanism;

mechanism! {
    /// A rod that is held at both ends, farther apart than it is long.
    pub struct Stretched {
        bodies: { bar: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1], markers: { END: [1.0, 0.0, 0.0] } } },
        joints: {
            left: spherical(ground, bar),
            right: spherical(bar.END, ground.at([3.0, 0.0, 0.0])),
        },
    }
}

#[test]
fn the_joint_is_named_with_its_residual() {
    let model = Stretched::new();
    let before = model.at_rest();
    let mut mechanism = model.in_motion(before);
    let refused = mechanism.assemble().unwrap_err();
    assert_eq!(mechanism.state, before);
    assert!(refused.joint == "left" || refused.joint == "right");
    let text = refused.to_string();
    assert!(text.contains("joint `") && text.contains("is off by 1.0"), "{text}");
}
