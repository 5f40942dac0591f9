//! A flexible slider-crank that turns freely: its energy should stay what it was.

use ffrf::nalgebra::{Quaternion, RealField, SVector, UnitQuaternion, Vector3};
use ffrf::{FreeBody, State};

use crate::motion::{Choice, Motion, place, plain};
use crate::rod::rods;

/// Step of the linearly implicit method. Units: s.
const STEP: f64 = 2e-5;
/// Radius of the crank. Units: m.
const RADIUS: f64 = 0.04;
/// Speed of the crank at the start. Units: rad/s.
const SPEED: f64 = 150.0;
const CRANK_MASS: f64 = 0.5;
const CRANK_CENTER: f64 = 0.01;
/// About the centre of mass and the axis that it turns about. Units: kg m².
const CRANK_INERTIA: f64 = 5e-4;
const PISTON_MASS: f64 = 0.3;
const GRAVITY: f64 = -9.81;

/// A rigid body in the plane: ½ m v² + ½ J ω² + m g h.
fn rigid_energy<T: RealField + Copy, const M: usize>(
    state: &State<SVector<T, M>, T>,
    mass: f64,
    center: f64,
    inertia: f64,
) -> f64 {
    let [position, velocity, spin] =
        [&state.position, &state.velocity, &state.angular_velocity].map(|vector| vector.map(plain));
    let orientation = UnitQuaternion::new_unchecked(Quaternion::from(state.orientation.coords.map(plain)));
    let arm = orientation * Vector3::new(center, 0.0, 0.0);
    let velocity = velocity + (orientation * spin).cross(&arm);
    0.5 * mass * velocity.norm_squared() + 0.5 * inertia * spin.z * spin.z
        - mass * GRAVITY * (position + arm).y
}

macro_rules! slider_crank {
    ($module:ident: $rod:ident, $scalar:ident) => {
        mod $module {
            use super::*;

            ffrf::mechanism! {
                /// A crank, a flexible rod, a piston.
                pub struct SliderCrank {
                    bodies: {
                        crank: rigid {
                            mass: CRANK_MASS,
                            center_of_mass: [CRANK_CENTER, 0.0, 0.0],
                            inertia: [2e-4, 4e-4, CRANK_INERTIA],
                            markers: { PIN: [RADIUS, 0.0, 0.0] },
                        },
                        rod: rods::$rod,
                        piston: rigid { mass: PISTON_MASS, inertia: [1e-4, 1e-4, 1e-4] },
                    },
                    gravity: [0.0, GRAVITY, 0.0],
                    joints: {
                        main: revolute(ground, crank, axis: z),
                        big_end: revolute(crank.PIN, rod.BIG_END, axis: z),
                        small_end: spherical(rod.SMALL_END, piston),
                        guide: prismatic(ground, piston, axis: x),
                    },
                    scalar: $scalar,
                }
            }

            pub struct Turning(ffrf::mechanism::Mechanism<SliderCrank, $scalar>);

            impl Turning {
                pub fn stretched() -> Result<Self, String> {
                    let model = SliderCrank::new(rods::$rod);
                    let mut state = model.at_rest();
                    state.rod.position.x = RADIUS as $scalar - rods::$rod::BIG_END.position.x;
                    state.piston.position.x = state.rod.position.x + rods::$rod::SMALL_END.position.x;
                    state.crank.angular_velocity.z = SPEED as $scalar;
                    let mut mechanism = model.in_motion(state);
                    mechanism.assemble().map_err(|error| error.to_string())?;
                    Ok(Self(mechanism))
                }
            }

            impl Motion for Turning {
                fn step(&mut self) -> Result<(), String> {
                    self.0
                        .step_linearly_implicit(STEP as $scalar)
                        .map(|_| ())
                        .map_err(|error| error.to_string())
                }

                fn step_size(&self) -> f64 {
                    STEP
                }

                fn energy(&self) -> f64 {
                    let state = &self.0.state;
                    let rod = FreeBody::new(rods::$rod).with_state(state.rod.clone());
                    let gravity = Vector3::new(0.0, GRAVITY as $scalar, 0.0);
                    let flexible =
                        rod.kinetic_energy() + rod.elastic_energy() + rod.potential_energy(&gravity);
                    rigid_energy(&state.crank, CRANK_MASS, CRANK_CENTER, CRANK_INERTIA)
                        + rigid_energy(&state.piston, PISTON_MASS, 0.0, 0.0)
                        + f64::from(flexible)
                }

                fn look(&self, numbers: &mut Vec<f64>) {
                    let state = &self.0.state;
                    place(numbers, &state.crank.position, &state.crank.orientation, &[]);
                    place(
                        numbers,
                        &state.rod.position,
                        &state.rod.orientation,
                        state.rod.modal_coordinates.as_slice(),
                    );
                    place(numbers, &state.piston.position, &state.piston.orientation, &[]);
                }
            }
        }
    };
}

slider_crank!(m0_f64: M0FullF64, f64);
slider_crank!(m0_f32: M0FullF32, f32);
slider_crank!(m4_full_f64: M4FullF64, f64);
slider_crank!(m4_full_f32: M4FullF32, f32);
slider_crank!(m4_linear_f64: M4LinearF64, f64);
slider_crank!(m4_linear_f32: M4LinearF32, f32);
slider_crank!(m8_full_f64: M8FullF64, f64);
slider_crank!(m8_full_f32: M8FullF32, f32);
slider_crank!(m8_linear_f64: M8LinearF64, f64);
slider_crank!(m8_linear_f32: M8LinearF32, f32);

/// The slider-crank. Errors: there is none of this choice, or its joints cannot be met.
pub fn turning(choice: Choice) -> Result<Box<dyn Motion>, String> {
    macro_rules! started {
        ($module:ident) => {
            Ok(Box::new($module::Turning::stretched()?))
        };
    }
    let Choice { modes, linear, single } = choice;
    match (modes, linear, single) {
        (0, _, false) => started!(m0_f64),
        (0, _, true) => started!(m0_f32),
        (4, false, false) => started!(m4_full_f64),
        (4, false, true) => started!(m4_full_f32),
        (4, true, false) => started!(m4_linear_f64),
        (4, true, true) => started!(m4_linear_f32),
        (8, false, false) => started!(m8_full_f64),
        (8, false, true) => started!(m8_full_f32),
        (8, true, false) => started!(m8_linear_f64),
        (8, true, true) => started!(m8_linear_f32),
        _ => Err(format!("there is no slider-crank of {modes} modes here")),
    }
}
