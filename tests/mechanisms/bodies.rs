//! The bodies and mechanisms of these tests.

use ffrf::nalgebra::Vector3;
use ffrf::{FlexibleBody, Observables, State, flexible_body, mechanism};

flexible_body! {
    /// The steel connecting rod of `models/conrod` with four modes.
    pub struct Rod { model: "models/conrod.ffrf.json", modes: ..4 }
}

flexible_body! {
    /// The same with all its modes.
    pub struct WholeRod { model: "models/conrod.ffrf.json" }
}

flexible_body! {
    /// The same in any number type.
    pub struct GenericRod { model: "models/conrod.ffrf.json", modes: ..4, scalar: generic }
}

/// Of the rod's big end in its frame. Units: m.
pub const BIG_END: f64 = -0.04740099151709372;
/// Of its small end.
pub const SMALL_END: f64 = 0.10225900184225423;
/// Radius of the crank.
pub const RADIUS: f64 = 0.04;

mechanism! {
    /// The rod as a pendulum about its big end: `models/scenes/flexible_pendulum.toml`.
    pub struct Pendulum {
        bodies: { rod: WholeRod },
        gravity: [0.0, -9.81, 0.0],
        joints: { pin: revolute(ground, rod.BIG_END) },
        sensors: {
            tip: position(rod.SMALL_END),
            speed: velocity(rod.SMALL_END),
            tilt: orientation(rod.SMALL_END),
            shock: acceleration(rod.SMALL_END),
            swing: angle(pin),
            load: reaction_force(pin),
            bending: reaction_moment(pin),
        },
    }
}

mechanism! {
    /// A flexible slider-crank: `models/scenes/slider_crank.toml`.
    pub struct SliderCrank {
        bodies: {
            crank: rigid {
                mass: 0.5,
                center_of_mass: [0.01, 0.0, 0.0],
                inertia: [2e-4, 4e-4, 5e-4],
                markers: { PIN: [RADIUS, 0.0, 0.0] },
            },
            rod: Rod,
            piston: rigid { mass: 0.3, inertia: [1e-4; 3] },
        },
        gravity: [0.0, 0.0, -9.81],
        joints: {
            main: revolute(ground, crank, axis: z),
            big_end: revolute(crank.PIN, rod.BIG_END, axis: z),
            small_end: spherical(rod.SMALL_END, piston),
            guide: prismatic(ground, piston, axis: x),
        },
        drives: { motor: angle(main, polynomial: [0.0, 100.0]) },
        sensors: {
            stroke: position(piston),
            bearing: reaction_force(main),
            pin: reaction_force(big_end),
            turn: angle(main),
        },
    }
}

impl SliderCrankState {
    /// Stretched out along x, as the scene has it.
    pub fn stretched(model: &SliderCrank) -> Self {
        let mut state = model.at_rest();
        state.rod.position.x = RADIUS - BIG_END;
        state.piston.position.x = RADIUS - BIG_END + SMALL_END;
        state
    }
}

/// Kinetic, elastic and gravitational energy. Units: J.
pub fn energy<B: FlexibleBody + Observables>(
    body: &B,
    state: &State<<B as FlexibleBody>::Modal>,
    gravity: &Vector3<f64>,
) -> f64 {
    let q = &state.modal_coordinates;
    let moment = state.position * body.mass() + state.to_inertial(&body.first_mass_moment(q));
    body.kinetic_energy(q, &state.body_velocity(), &state.angular_velocity, &state.modal_rates)
        + body.elastic_energy(q)
        - gravity.dot(&moment)
}
