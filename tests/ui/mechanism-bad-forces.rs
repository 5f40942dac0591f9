//! Friction, functions of the user's own, controls, treatments and indices of joints that cannot be.
ffrf::mechanism! {
    pub struct Pendulum {
        bodies: { bar: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1] }, links: [rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1] }; 3] },
        joints: {
            pin: revolute(ground, bar, axis: y),
            ball: spherical(ground, bar),
            hinges: for i in 1..3 { revolute(links[i - 1], links[i], axis: y) },
            root: revolute(ground, links[0], axis: y),
        },
        constraints: relaxed,
        controls: { throttle: 0.0, pin: 1.0 },
        drives: { motors: for i in 0..2 { angle(hinges[i]) }, twice: for k in 1..3 { angle(hinges[1]) } },
        forces: {
            one: friction(ball, limit: 1.0, speed: 0.1),
            two: friction(pin, coefficient: 0.1, speed: 0.1),
            three: friction(ground, bar, coefficient: 0.1, speed: 0.1),
            four: friction(pin, limit: 1.0, speed: 0.1, radius: 0.1),
            five: friction(pin, limit: 1.0, speed: 0.1, acts: sideways),
            six: torsion_spring(hinges, stiffness: 1.0),
            seven: torsion_spring(hinges[5], stiffness: 1.0),
            eight: torsion_spring(pin[0], stiffness: 1.0),
            nine: for i in 0..2 { user(|_, _, _| ()) },
            ten: user(),
        },
        sensors: { turns: for i in 0..3 { angle(hinges[i]) } },
    }
}

ffrf::mechanism! {
    pub struct Minimal {
        bodies: { bar: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1] } },
        joints: { pin: revolute(ground, bar, axis: y) },
        constraints: minimal,
    }
}

ffrf::mechanism! {
    pub struct Drawn {
        bodies: { bar: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1] } },
        joints: { pin: revolute(ground, bar, axis: y) },
        constraints: baumgarte(alpha: 1.0, gamma: 2.0),
    }
}

ffrf::mechanism! {
    pub struct Pushed {
        bodies: { bar: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1] } },
        joints: { pin: revolute(ground, bar, axis: y) },
        forces: { wind: user(|model, time: f64| ()) },
    }
}

fn main() {}
