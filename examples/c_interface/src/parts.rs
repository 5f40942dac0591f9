//! The machine: bodies and mechanism, as any Rust program declares them.

use ffrf::forces::{Frame, MarkerLoad};
use ffrf::mechanism::Mechanism;
use ffrf::nalgebra::{SVector, Vector3};
use ffrf::{FreeBody, Gravity, StepError};

ffrf::flexible_body! {
    /// The connecting rod of the main example with its four lowest modes.
    pub struct Rod { model: "../../models/conrod.ffrf.json", modes: ..4 }
}

/// Radius of the crank. Units: m.
pub const RADIUS: f64 = 0.04;

ffrf::mechanism! {
    /// A crank that a motor turns, a flexible rod, a piston.
    pub struct SliderCrank {
        bodies: {
            crank: rigid {
                mass: 0.5,
                center_of_mass: [0.01, 0.0, 0.0],
                inertia: [2e-4, 4e-4, 5e-4],
                markers: { PIN: [RADIUS, 0.0, 0.0] },
            },
            rod: Rod,
            piston: rigid { mass: 0.3, inertia: [1e-4, 1e-4, 1e-4] },
        },
        gravity: [0.0, 0.0, -9.81],
        joints: {
            main: revolute(ground, crank, axis: z),
            big_end: revolute(crank.PIN, rod.BIG_END, axis: z),
            small_end: spherical(rod.SMALL_END, piston),
            guide: prismatic(ground, piston, axis: x),
        },
        forces: { motor: actuator(main) },
        sensors: { stroke: position(piston), bearing: reaction_force(main) },
    }
}

/// The slider-crank at rest, stretched out along x.
pub fn slider_crank() -> Mechanism<SliderCrank> {
    let model = SliderCrank::new(Rod);
    let mut state = model.at_rest();
    state.rod.position.x = RADIUS - Rod::BIG_END.position.x;
    state.piston.position.x = state.rod.position.x + Rod::SMALL_END.position.x;
    model.in_motion(state)
}

/// A rod that flies under gravity and a force at its small end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeRod {
    /// The rod with its state and time.
    pub rod: FreeBody<Rod>,
    /// Uniform gravity.
    pub gravity: Gravity,
    /// The force. Frame: inertial.
    pub push: MarkerLoad<SVector<f64, 4>>,
}

impl FreeRod {
    /// At rest at the origin, without a force. Units: `gravity` m/s², inertial.
    pub fn new(gravity: Vector3<f64>) -> Self {
        Self {
            rod: FreeBody::new(Rod),
            gravity: Gravity { acceleration: gravity },
            push: MarkerLoad::force(Rod::SMALL_END, Vector3::zeros(), Frame::Inertial),
        }
    }

    /// One explicit step of order four. Units: s. Errors: see [`StepError`]; state and time are then unchanged.
    pub fn step(&mut self, step: f64) -> Result<(), StepError> {
        self.rod.step_rk4(step, &(self.gravity, self.push)).map(|_| ())
    }
}
