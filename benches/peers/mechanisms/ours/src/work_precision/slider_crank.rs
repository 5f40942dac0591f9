//! The flexible slider-crank of Simeon: a crank driven at 150 rad/s, no gravity.

use ffrf::nalgebra::{SVector, Vector3};

use crate::advance::{self, Request};

mod rod {
    include!(concat!(env!("OUT_DIR"), "/rod.rs"));
}
mod straight_line {
    include!(concat!(env!("OUT_DIR"), "/slider_crank_straight_line.rs"));
}
use rod::Rod;

macro_rules! slider_crank {
    ($name:ident $state:ident $run:ident { $($functions:tt)* }) => {
        ffrf::mechanism! {
            /// Crank, rod with two lateral and two axial modes, slider.
            pub struct $name {
                bodies: {
                    crank: rigid { mass: 0.36, inertia: [0.002727; 3], markers: { PIN: [0.15, 0.0, 0.0] } },
                    rod: Rod,
                    slider: rigid { mass: 0.075552, inertia: [1e-4; 3] },
                },
                joints: {
                    main: revolute(ground, crank, axis: z),
                    big_end: revolute(crank.PIN, rod.ROOT, axis: z),
                    small_end: in_line(slider, rod.TIP, axis: z),
                    guide: prismatic(ground, slider, axis: x),
                },
                drives: { motor: angle(main, polynomial: [0.0, 150.0]) },
                sensors: { tip: position(rod.TIP), middle: position(rod.MIDDLE) },
                $($functions)*
            }
        }

        fn $run(request: &Request) -> Result<String, String> {
            let model = $name::new(Rod);
            let mut state = model.at_rest();
            state.crank.angular_velocity.z = 150.0;
            state.rod.position.x = 0.15;
            state.rod.velocity.y = 22.5;
            state.rod.angular_velocity.z = -74.99576703969453;
            state.rod.modal_coordinates = SVector::from([0.0, 0.0, 1.03339863e-5, 1.69327969e-5]);
            state.rod.modal_rates =
                SVector::from([0.4448961125815990, 4.634339319238670e-3, -1.78591076e-6, -2.68938672e-6]);
            state.slider.position.x = 0.450016933;
            state.slider.velocity.x = -2.68938672e-6;
            let mut start = model.in_motion(state);
            start.assemble().map_err(|error| error.to_string())?;
            let observe = |model: &$name, state: &$state| {
                let points: [Vector3<f64>; 2] = [model.tip(state), model.middle(state)];
                points.iter().flat_map(|point| point.iter().copied().collect::<Vec<_>>()).collect()
            };
            advance::run(&start, request, observe, |state| {
                let (rod, q) = (&state.rod, &state.rod);
                let turn = rod.orientation.scaled_axis();
                format!(
                    "{{\"position\": {:?}, \"rotation\": {:?}, \"velocity\": {:?}, \"angular_velocity\": {:?}, \"q\": {:?}, \"q_dot\": {:?}, \
                     \"crank\": {:?}, \"crank_rate\": {:?}, \"slider\": {:?}, \"slider_rate\": {:?}}}",
                    rod.position.as_slice(),
                    turn.as_slice(),
                    rod.velocity.as_slice(),
                    rod.angular_velocity.as_slice(),
                    q.modal_coordinates.as_slice(),
                    q.modal_rates.as_slice(),
                    state.crank.orientation.scaled_axis().z,
                    state.crank.angular_velocity.z,
                    state.slider.position.x,
                    state.slider.velocity.x,
                )
            })
        }
    };
}
slider_crank!(SliderCrank SliderCrankState general {});
slider_crank!(Straight StraightState straight {
    accelerations: straight_line::accelerations,
    implicit_accelerations: straight_line::implicit_accelerations,
    projection: straight_line::projection,
    implicit_projection: straight_line::implicit_projection,
});

/// The initial values of crank.f, moved to where the joints are met to round-off; observed: the rod's tip and middle.
pub fn run(request: &Request) -> Result<String, String> {
    if request.is_straight() { straight(request) } else { general(request) }
}
