//! The rotor of Exudyn's test `perfObjectFFRFreducedOrder` on two spring supports.

use ffrf::nalgebra::Vector3;

use crate::advance::{self, Request};

mod rotor {
    include!(concat!(env!("OUT_DIR"), "/rotor.rs"));
}
mod straight_line {
    include!(concat!(env!("OUT_DIR"), "/rotor_straight_line.rs"));
}
use rotor::Rotor;

/// Of the supports, and half the rotor's length. Units: N/m, N s/m.
const STIFFNESS: f64 = 2e8;
const DAMPING: f64 = 2e6;
/// Units: rad/s.
const SPEED: f64 = 100.0 * std::f64::consts::PI;

macro_rules! supported {
    ($name:ident $state:ident $run:ident { $($functions:tt)* }) => {
        ffrf::mechanism! {
            /// The right support has no stiffness along the axis.
            pub struct $name {
                bodies: { rotor: free Rotor },
                forces: {
                    left: bushing(ground.at([0.0, 0.0, 0.0]), rotor.LEFT,
                        stiffness: [STIFFNESS, STIFFNESS, STIFFNESS, 0.0, 0.0, 0.0],
                        damping: [DAMPING, DAMPING, DAMPING, 0.0, 0.0, 0.0]),
                    right: bushing(ground.at([0.0, 0.0, 0.5]), rotor.RIGHT,
                        stiffness: [STIFFNESS, STIFFNESS, 0.0, 0.0, 0.0, 0.0],
                        damping: [DAMPING, DAMPING, DAMPING, 0.0, 0.0, 0.0]),
                },
                sensors: {
                    left_end: position(rotor.LEFT),
                    middle: position(rotor.MIDDLE),
                    right_end: position(rotor.RIGHT),
                },
                $($functions)*
            }
        }

        fn $run(request: &Request) -> Result<String, String> {
            let model = $name::new(Rotor);
            let mut state = model.at_rest();
            state.rotor.angular_velocity.z = SPEED;
            let observe = |model: &$name, state: &$state| {
                let points: [Vector3<f64>; 3] =
                    [model.left_end(state), model.middle(state), model.right_end(state)];
                points.iter().flat_map(|point| point.iter().copied().collect::<Vec<_>>()).collect()
            };
            advance::run(&model.in_motion(state), request, observe, |state| {
                format!("{{\"angular_velocity\": {:?}}}", state.rotor.angular_velocity.as_slice())
            })
        }
    };
}
supported!(Supported SupportedState general {});
supported!(Straight StraightState straight {
    accelerations: straight_line::accelerations,
    implicit_accelerations: straight_line::implicit_accelerations,
});

/// It turns at rest, without its unbalance's deflection; observed: both ends and the middle.
pub fn run(request: &Request) -> Result<String, String> {
    if request.is_straight() { straight(request) } else { general(request) }
}
