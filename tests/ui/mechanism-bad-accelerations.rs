//! Functions that do not fit a mechanism, and mechanisms that no function can follow.
fn of_no_modes(_: &[f64; 13], _: &[[f64; 3]; 1], _: &mut [f64; 6]) -> bool {
    false
}

ffrf::mechanism! {
    pub struct Changing {
        bodies: { bar: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1] } },
        joints: { pin: revolute(ground, bar, axis: y) },
        constraints: baumgarte(alpha: 1.0, beta: 2.0),
        controls: { throttle: 0.0 },
        forces: {
            fine: torsion_spring(pin, stiffness: 1.0),
            rub: friction(pin, limit: 1.0, speed: 0.1),
            bearing: friction(pin, coefficient: 0.1, radius: 0.01, speed: 0.1),
            motor: actuator(pin),
            wind: user(|_, _, _| ()),
        },
        accelerations: of_no_modes,
    }
}

ffrf::mechanism! {
    pub struct Generic {
        bodies: { bar: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1] } },
        joints: { pin: revolute(ground, bar, axis: y) },
        accelerations: of_no_modes,
        scalar: generic,
    }
}

ffrf::mechanism! {
    pub struct Quoted {
        bodies: { bar: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1] } },
        joints: { pin: revolute(ground, bar, axis: y) },
        accelerations: "printed.rs",
    }
}

fn main() {}
