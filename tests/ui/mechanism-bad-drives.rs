//! Drives of joints that cannot be driven.
ffrf::mechanism! {
    pub struct Pendulum {
        bodies: { bar: rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1], markers: { END: [1.0, 0.0, 0.0] } }, links: [rigid { mass: 1.0, inertia: [0.1, 0.1, 0.1], markers: { END: [1.0, 0.0, 0.0] } }; 2] },
        joints: {
            pin: revolute(ground, bar, axis: y),
            ball: spherical(ground, bar),
            hinges: for i in 0..2 { revolute(ground, links[i], axis: y) },
        },
        drives: {
            one: angle(ball),
            two: position(pin),
            three: angle(pen),
            four: angle(hinges),
            five: angle(pin),
            six: angle(pin),
            seven: angle(pin, polynomial: [1.0], function: f64::sin),
        },
    }
}

fn main() {}
