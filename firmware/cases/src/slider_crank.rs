//! A flexible slider-crank at 1 kHz: a speed controller turns the crank, a spring and friction act in the pin.

use ffrf::nalgebra;

use crate::bodies::{Eight32, Eight64, Four32, Four64};
use crate::motion::follow;
use crate::{Hash, Motion, Sink};

/// Tick of the controller and step of the integrator. Units: s.
const TICK: f64 = 1e-3;
/// Speed that the controller holds. Units: rad/s.
const SPEED: f64 = 40.0;
/// Gain of the controller. Units: N m s.
const GAIN: f64 = 0.05;
/// Radius of the crank. Units: m.
const RADIUS: f64 = 0.04;

/// Types of one scalar, number of modes, and torque or drive.
macro_rules! slider_crank {
    ($module:ident: $rod:ident, $scalar:ident, { $($drive:tt)* }) => {
        /// One slider-crank.
        pub mod $module {
            use super::*;

            ffrf::mechanism! {
                /// A crank, a flexible rod, a piston: one loop with redundant rows.
                pub struct SliderCrank {
                    bodies: {
                        crank: rigid {
                            mass: 0.5,
                            center_of_mass: [0.01, 0.0, 0.0],
                            inertia: [2e-4, 4e-4, 5e-4],
                            markers: { PIN: [RADIUS, 0.0, 0.0] },
                        },
                        rod: $rod,
                        piston: rigid { mass: 0.3, inertia: [1e-4, 1e-4, 1e-4] },
                    },
                    gravity: [0.0, 0.0, -9.81],
                    joints: {
                        main: revolute(ground, crank, axis: z),
                        big_end: revolute(crank.PIN, rod.BIG_END, axis: z),
                        small_end: spherical(rod.SMALL_END, piston),
                        guide: prismatic(ground, piston, axis: x),
                    },
                    drives: { $($drive)* },
                    forces: {
                        motor: actuator(main),
                        pin: torsion_spring(big_end, stiffness: 0.02, damping: 1e-4),
                    },
                    scalar: $scalar,
                }
            }

            /// A slider-crank in motion, or why there is none.
            pub struct Running(Option<ffrf::mechanism::Mechanism<SliderCrank, $scalar>>);

            impl Running {
                /// Stretched out along x and at rest.
                pub fn stretched() -> Self {
                    let model = SliderCrank::new($rod);
                    let mut state = model.at_rest();
                    let radius: $scalar = nalgebra::convert(RADIUS);
                    state.rod.position.x = radius - $rod::BIG_END.position.x;
                    state.piston.position.x = state.rod.position.x + $rod::SMALL_END.position.x;
                    let mut mechanism = model.in_motion(state);
                    let assembled = mechanism.assemble().is_ok();
                    Self(assembled.then_some(mechanism))
                }
            }

            impl Motion for Running {
                fn step(&mut self) -> bool {
                    let Some(mechanism) = &mut self.0 else { return false };
                    let speed = mechanism.state.crank.angular_velocity.z;
                    mechanism.model.motor.kind.moment = (SPEED as $scalar - speed) * GAIN as $scalar;
                    mechanism.step_linearly_implicit(TICK as $scalar).is_ok()
                }

                fn hash(&self, hash: &mut Hash) {
                    if let Some(mechanism) = &self.0 {
                        hash.numbers(&mechanism.state.to_array());
                    }
                }
            }
        }
    };
}

slider_crank!(four32: Four32, f32, {});
slider_crank!(eight32: Eight32, f32, {});
slider_crank!(four64: Four64, f64, {});
slider_crank!(eight64: Eight64, f64, {});
slider_crank!(driven64: Four64, f64, { shaft: angle(main, polynomial: [0.0, 40.0]) });

macro_rules! cases {
    ($($name:ident: $module:ident;)*) => {$(
        pub fn $name(steps: u32, sink: Sink<'_>) {
            follow($module::Running::stretched(), steps, sink);
        }
    )*};
}

cases! {
    four_f32: four32;
    eight_f32: eight32;
    four_f64: four64;
    eight_f64: eight64;
    driven_f64: driven64;
}
